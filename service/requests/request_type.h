#pragma once

// How a request is declared: a struct, and a description beside it whose members are bound to the struct's by name.
// service/requests/inspect.cpp is a small example. The compiler knows the type of each member, so the description
// cannot say another one.

#include <algorithm>
#include <array>
#include <functional>
#include <type_traits>

#include "graph/arguments.h"
#include "service/engine.h"
#include "service/requests/description.h"

namespace dini {

/// How a member of type T is described, and set from a value that `fault_in` finds nothing wrong with.
template <class T>
struct MemberTraits;

template <>
struct MemberTraits<Json> {
  static constexpr MemberKind kind = MemberKind::object;
  static Json taken(Json&& value) { return std::move(value); }
};
template <>
struct MemberTraits<std::string> {
  static constexpr MemberKind kind = MemberKind::text;
  static std::string taken(Json&& value) { return value.get<std::string>(); }
};
template <>
struct MemberTraits<bool> {
  static constexpr MemberKind kind = MemberKind::boolean;
  static bool taken(Json&& value) { return value.get<bool>(); }
};
template <>
struct MemberTraits<std::int64_t> {
  static constexpr MemberKind kind = MemberKind::integer;
  static std::int64_t taken(Json&& value) {
    // What lies beyond is out of any range as well.
    constexpr double largest = 9007199254740992;
    return static_cast<std::int64_t>(std::clamp(value.get<double>(), -largest, largest));
  }
};
template <>
struct MemberTraits<std::vector<std::string>> {
  static constexpr MemberKind kind = MemberKind::texts;
  static std::vector<std::string> taken(Json&& value) { return value.get<std::vector<std::string>>(); }
};
template <class T>
struct MemberTraits<std::optional<T>> : MemberTraits<T> {};
template <ChoiceEnum E>
struct MemberTraits<E> {
  static constexpr MemberKind kind = MemberKind::choice;
  static E taken(Json&& value) {
    const auto& names = ChoiceNames<E>::names;
    const auto place = std::ranges::find(names, value.get_ref<const std::string&>());
    return static_cast<E>(place - names.begin());
  }
};

/// A request of type T: its description, and the reader that follows from it.
template <class T>
class RequestType {
 public:
  RequestType(std::string name, std::string doc) : description_{std::move(name), std::move(doc)} {}

  /// A member whose value goes to one of T.
  template <class Value, class Owner>
  requires std::is_base_of_v<Owner, T> RequestType &&
      member(std::string name, Value Owner::*place, std::string doc, MemberSpec spec) && {
    using Traits = MemberTraits<Value>;
    Member member{std::move(name), std::move(doc), Traits::kind, std::move(spec)};
    if constexpr (ChoiceEnum<Value>) {
      member.choices.assign(ChoiceNames<Value>::names.begin(), ChoiceNames<Value>::names.end());
    }
    description_.members.push_back(std::move(member));
    setters_.push_back(
        [place](T& request, Json&& value, const Engine&) { request.*place = Traits::taken(std::move(value)); });
    return std::move(*this);
  }
  /// The member that holds the graph document. What the document has besides goes to the notes of an evaluation.
  template <class Owner>
  requires std::is_base_of_v<Owner, T> RequestType && graph(SharedGraph Owner::*place, std::string doc) && {
    description_.members.push_back({"graph", std::move(doc), MemberKind::graph, needed().example(example_graph())});
    setters_.push_back([place](T& request, Json&& document, const Engine& engine) {
      request.*place = engine.read(document);
      if constexpr (std::is_base_of_v<EvaluateRequest, T>) request.notes = notes_of(document);
    });
    return std::move(*this);
  }

  /// The member that holds values for the parameters of that graph.
  template <class Owner>
  requires std::is_base_of_v<Owner, T> RequestType && parameters(Json Owner::*place) && {
    return std::move(*this).member("parameters", place, "Values for the parameters of the graph, by name.",
                                   left_out_means("their defaults").example({{"reach", 0.5}}));
  }
  /// A member that is a list of objects.
  template <class Owner>
  requires std::is_base_of_v<Owner, T> RequestType &&
      objects(std::string name, Json Owner::*place, std::string doc, MemberSpec spec) && {
    auto&& declared = std::move(*this).member(std::move(name), place, std::move(doc), std::move(spec));
    description_.members.back().kind = MemberKind::objects;
    return std::move(declared);
  }
  /// The member that says until when.
  template <class Owner>
  requires std::is_base_of_v<Owner, T> RequestType &&
      deadline(std::optional<std::int64_t> Owner::*place, const std::string& limit = "interactive_milliseconds") && {
    return std::move(*this).member("deadline_ms", place,
                                   "When the work is stopped, counted from the first byte of the request.",
                                   left_out_means("`" + limit + "`, which it never goes past").range(1, {}).unit("ms"));
  }

  const RequestDescription& description() const { return description_; }

  /// A body from outside, whose graph the engine reads. Members that are left out have the defaults of the struct.
  Result<T> read(Json body, const Engine& engine) const {
    ProblemCollector faults = faults_in(description_, body);
    if (!faults.empty()) return std::move(faults).take();
    T request{};
    for (std::size_t i = 0; i < setters_.size(); ++i) {
      const auto given = body.find(description_.members[i].name);
      if (given != body.end()) setters_[i](request, std::move(*given), engine);
    }
    return request;
  }

 private:
  RequestDescription description_;
  std::vector<std::function<void(T&, Json&&, const Engine&)>> setters_;  ///< as the members of the description
};

}  // namespace dini

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graph/problem.h"

namespace dini {

/// What kind of value a member of a request takes.
enum class MemberKind { graph, object, text, choice, boolean, integer, texts, objects };

/// What a description says about a member beside its name and sentence: default, range, unit, example.
class MemberSpec {
 public:
  /// The range that is accepted, both ends included; an end that is missing is open.
  MemberSpec&& range(std::optional<std::int64_t> lowest, std::optional<std::int64_t> highest) && {
    least = lowest;
    most = highest;
    return std::move(*this);
  }
  MemberSpec&& unit(std::string text) && {
    unit_text = std::move(text);
    return std::move(*this);
  }
  /// What stands for the member in the example of the whole request.
  MemberSpec&& example(Json value) && {
    example_value = std::move(value);
    return std::move(*this);
  }

  bool is_required = false;
  Json default_value = nullptr;  ///< null: nothing stands for the member when it is left out
  std::string when_missing = {};
  std::optional<std::int64_t> least = {}, most = {};
  std::string unit_text = {};
  Json example_value = nullptr;
};

/// The spec of a member that must be given.
inline MemberSpec needed() {
  MemberSpec spec;
  spec.is_required = true;
  return spec;
}
/// The spec of a member that may be left out, and means this then.
inline MemberSpec usually(Json value) {
  MemberSpec spec;
  spec.default_value = std::move(value);
  return spec;
}
/// The spec of a member that may be left out; a few words say what happens then.
inline MemberSpec left_out_means(std::string words) {
  MemberSpec spec;
  spec.when_missing = std::move(words);
  return spec;
}

/// One member of a request.
struct Member {
  std::string name;
  std::string doc;  ///< one sentence
  MemberKind kind = MemberKind::text;
  MemberSpec spec = {};
  std::vector<std::string> choices = {};
};

/// The words for a kind of value in problems and documentation: "an object", "a whole number".
std::string words_for(MemberKind kind);

/// The type in JSON Schema, with the range, choices, default and example of the member.
Json schema_of(const Member& member);

/// What is wrong with a value for a member; nothing if it can be taken. The pointer is that of the member in a body.
std::optional<Problem> fault_in(const Member& member, const Json& value);

}  // namespace dini

#pragma once

// Problems and results: how every layer above geometry says that something cannot be done.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace dini {

using Json = nlohmann::json;

/// One thing that is wrong, with its place. `code` is a stable kebab-case word; `detail` is one sentence with the
/// numbers and what would be accepted; `pointer` (RFC 6901) points into the request document; `fix` is a JSON Patch
/// where one is known.
struct Problem {
  std::string code = {};
  std::string detail = {};
  std::string node = {};
  std::string port = {};
  std::string pointer = {};
  Json fix = nullptr;
};

using Problems = std::vector<Problem>;

/// Either a value or the problems that prevented it (at least one).
template <class T>
class Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Problem problem) : state_(std::in_place_index<1>, Problems{std::move(problem)}) {}
  Result(Problems problems) : state_(std::in_place_index<1>, std::move(problems)) {}

  bool has_value() const { return state_.index() == 0; }
  explicit operator bool() const { return has_value(); }

  const T& value() const& { return std::get<0>(state_); }
  T& value() & { return std::get<0>(state_); }
  T&& value() && { return std::get<0>(std::move(state_)); }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::get<0>(std::move(state_)); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  const Problems& problems() const& { return std::get<1>(state_); }
  Problems&& problems() && { return std::get<1>(std::move(state_)); }

 private:
  std::variant<T, Problems> state_;
};

}  // namespace dini

#pragma once

// Problems and results: how every layer above geometry says that something cannot be done.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/expected.h"
#include "geometry/json.h"

namespace dini {

/// One thing that is wrong, with its place. `code` is a stable kebab-case word; `detail` is one sentence with the
/// numbers and what would be accepted; `pointer` (RFC 6901) leads into the graph document, empty for all of it and
/// absent where there is no place; `fix` is a JSON Patch (RFC 6902) of the document where one is known. With
/// `in_request` both are of the request around the document instead: its parameters, output, previews.
struct Problem {
  std::string code = {};
  std::string detail = {};
  std::string node = {};
  std::string port = {};
  std::optional<std::string> pointer = {};
  Json fix = nullptr;
  bool in_request = false;
};

using Problems = std::vector<Problem>;

/// Gathers problems: lists the first hundred and counts the others, so that no document can ask for an answer many
/// times its own size. What a problem says may take long to find (the nearest of all names, say), so it is only made
/// when it is listed.
class ProblemCollector {
 public:
  template <class Make>
  void add(Make make) {
    if (problems_.size() < most_listed) {
      problems_.push_back(make());
    } else {
      ++unlisted_;
    }
  }
  void add(Problem problem) {
    add([&] { return std::move(problem); });
  }
  void add(Problems problems) {
    for (Problem& problem : problems) add(std::move(problem));
  }

  /// All of another collector's, in its order.
  void add(ProblemCollector other) {
    add(std::move(other.problems_));
    unlisted_ += other.unlisted_;
  }

  bool empty() const { return problems_.empty(); }
  std::size_t count() const { return problems_.size() + unlisted_; }

  /// All that were listed; the last one, with code `more-problems`, says how many were not.
  Problems take() &&;

 private:
  static constexpr std::size_t most_listed = 100;

  Problems problems_;
  std::size_t unlisted_ = 0;
};

/// Either a value or the problems that prevented it (at least one).
template <class T>
class Result : public Expected<T, Problems> {
 public:
  Result(T value) : Expected<T, Problems>(std::move(value)) {}
  Result(Problem problem) : Expected<T, Problems>(Problems{std::move(problem)}) {}
  Result(Problems problems) : Expected<T, Problems>(std::move(problems)) {}

  const Problems& problems() const& { return this->error(); }
  Problems&& problems() && { return std::move(*this).error(); }
};

}  // namespace dini

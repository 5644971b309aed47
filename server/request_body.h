#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/problem.h"

namespace dini::server {

/// The members of a JSON request body. Every problem is collected, so that one answer names them all.
class RequestBody {
 public:
  /// Members outside `known` are problems, with the nearest known name.
  RequestBody(Json body, std::initializer_list<std::string_view> known);

  /// An object; `required` ones that are missing are a problem, others are empty.
  Json object(std::string_view name, bool required);
  std::string text(std::string_view name, bool required);
  std::string choice(std::string_view name, std::initializer_list<std::string_view> choices);  ///< the first by default
  bool boolean(std::string_view name);                                                         ///< false by default
  std::optional<std::int64_t> positive_integer(std::string_view name);
  std::optional<std::int64_t> integer(std::string_view name);
  /// A list of texts; empty when it is missing.
  std::vector<std::string> texts(std::string_view name);

  /// Whether nothing was wrong with what was asked for so far.
  bool well() const { return problems_.empty(); }
  Problems problems() && { return std::move(problems_).take(); }

 private:
  const Json* find(std::string_view name, bool required);
  void wrong_type(std::string_view name, std::string_view expected);

  Json body_;
  ProblemCollector problems_;
};

}  // namespace dini::server

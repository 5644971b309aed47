#pragma once

// Every code of a problem or warning that there is. Codes are never renamed: programs look at them and never at the
// sentence of a problem. A test reads the sources and fails for a code that is not here.

#include <span>
#include <string_view>

namespace dini {

/// What a problem is about.
enum class ProblemKind {
  request,  ///< how something was asked for
  graph,    ///< a graph, its values, or what is computed from them
  file,     ///< a file that was sent
  service,  ///< what the service can do just now
  warning,  ///< told beside an answer, never instead of one
  program,  ///< told by the program itself, never by the server
};

struct ProblemCode {
  std::string_view code;  ///< kebab-case
  ProblemKind kind;
  int status;                ///< of an HTTP answer whose first problem it is; 0 when it is never that
  std::string_view meaning;  ///< one sentence
};

/// In the order in which people read them: by kind.
std::span<const ProblemCode> problem_codes();

/// Null for a code that does not exist.
const ProblemCode* find_problem_code(std::string_view code);

/// All kinds, in that order.
std::span<const ProblemKind> problem_kinds();

/// "about requests": the heading of the codes of a kind.
std::string_view title_of(ProblemKind kind);

}  // namespace dini

#pragma once

#include <string_view>

#include "graph/problem.h"

namespace dini::cli {

/// What the program ends with; scripts rely on these numbers.
enum ExitCode {
  exit_ok = 0,
  exit_check_failed = 1,  ///< a check of the graph did not hold
  exit_usage = 2,
  exit_invalid_graph = 3,
  exit_evaluation_failed = 4,
  exit_limit = 5,  ///< a limit or the deadline
  exit_io = 6,
  exit_our_bug = 70,
  exit_try_again = 75,  ///< of workers: the same may work later
};

/// The stage a problem turned up in: the same code (`out-of-range`, say) is the graph's fault before evaluation and a
/// failed evaluation after.
enum class Stage { checking, evaluating };

int exit_code_for(const Problems& problems, Stage stage);

}  // namespace dini::cli

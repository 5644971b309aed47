#include "cli/exit_codes.h"

namespace dini::cli {

int exit_code_for(const Problems& problems, Stage stage) {
  const std::string_view code = problems.front().code;
  if (code == "io") return exit_io;
  if (code == "usage") return exit_usage;
  if (code == "internal") return exit_our_bug;
  if (code == "check-failed") return exit_check_failed;
  if (code == "limit-exceeded" || code == "deadline" || code == "out-of-memory") return exit_limit;
  // What was asked for is not in the graph, whenever that was noticed.
  if (code == "unknown-node" || code == "unknown-output" || code == "unknown-port") return exit_invalid_graph;
  return stage == Stage::checking ? exit_invalid_graph : exit_evaluation_failed;
}

}  // namespace dini::cli

#include "cli/computing.h"

#include "algebra/kernels.h"
#include "cli/problems.h"

namespace dini::cli {

void Computing::add_options(CLI::App& command) {
  command.add_option("--threads", threads_, "Threads to compute with (default: one per core)")
      ->check(CLI::Range(1, 1024));
  command.add_option("--instruction-set", instruction_set_,
                     "Processor instructions to compute with (default: the best)");
}

Problems Computing::apply() {
  if (threads_ > 0) {
    control_ = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                     static_cast<std::size_t>(threads_));
  }
  if (instruction_set_.empty() || kernels::force_instruction_set(instruction_set_.c_str())) return {};
  std::string detail = "--instruction-set '" + instruction_set_ + "' is not available; there are";
  for (const char* name : kernels::instruction_sets()) detail += std::string(" ") + name;
  return {usage_problem(detail)};
}

std::size_t Computing::threads() const {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

}  // namespace dini::cli

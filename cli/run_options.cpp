#include "cli/run_options.h"

#include "cli/evaluation.h"

namespace dini::cli {

void RunOptions::add_options(CLI::App& command, const std::string& one, const std::string& many) {
  constexpr std::size_t most_milliseconds = 86'400'000, most_jobs = 1024;
  command.add_option("--jobs", jobs_, "How many " + many + " are evaluated at once (default: one per thread)")
      ->check(CLI::Range(std::size_t{1}, most_jobs));
  command.add_option("--deadline-ms", deadline_ms_, "Give up on one model after this many milliseconds")
      ->check(CLI::Range(std::size_t{1}, most_milliseconds));
  auto* fail_fast = command.add_flag("--fail-fast", fail_fast_, "Begin no further " + one + " after one has failed");
  command.add_flag("--keep-going", keep_going_, "Evaluate all " + many + " whatever comes of others (default)")
      ->excludes(fail_fast);
  computing_.add_options(command);
}

Job RunOptions::job() const { return job_within(deadline_ms_); }

}  // namespace dini::cli

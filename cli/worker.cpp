#include "jobs/worker.h"

#include <csignal>
#include <iostream>
#include <memory>
#include <spdlog/spdlog.h>

#include "cli/commands.h"
#include "cli/computing.h"
#include "cli/configuration.h"
#include "cli/ending_signals.h"
#include "cli/exit_codes.h"
#include "cli/given_queue.h"
#include "cli/limit_options.h"
#include "cli/log_sink.h"
#include "cli/problems.h"
#include "cli/terminal.h"
#include "cli/worker_metrics.h"
#include "jobs/process_memory.h"
#include "jobs/queue_identity.h"

namespace dini::cli {
namespace {

struct WorkerOptions {
  std::string queue;
  std::optional<std::string> metrics;
  std::uint64_t silence = 15'000;
  Limits limits;
  Computing computing;
  std::optional<Configuration> configuration;
};

/// A variant that is being computed is finished when the worker is told to end; one that takes longer than this is left
/// to another worker.
constexpr std::chrono::seconds patience_with_a_variant{25};

int run(WorkerOptions& options, const EngineMaker& make_engine) {
  if (const Problems unread = options.configuration->read(); !unread.empty()) return fail(unread, exit_usage);
  if (options.configuration->is_to_be_printed()) {
    std::cout << options.configuration->text();
    return exit_ok;
  }
  if (options.queue.empty()) {
    return fail({usage_problem("a worker needs a --queue, as redis://127.0.0.1:6379")}, exit_usage);
  }
  const auto address = read_queue(options.queue);
  if (!address) return fail(address.problems(), exit_usage);
  if (const Problems wrong = options.computing.apply(); !wrong.empty()) return fail(wrong, exit_usage);
  std::signal(SIGPIPE, SIG_IGN);
  EndingSignals signals(patience_with_a_variant);
  spdlog::set_default_logger(std::make_shared<spdlog::logger>("dini", log_sink()));
  spdlog::set_pattern("%Y-%m-%dT%H:%M:%S.%e %l %v");
  jobs::use_few_memory_pools();
  const std::unique_ptr<Engine> engine = make_engine(options.limits);
  signals.running();  // from here on there is something to put in order
  jobs::Worker worker(*engine, {.address = *address,
                                .threads = options.computing.threads(),
                                .silence = std::chrono::milliseconds(options.silence)});
  std::optional<WorkerMetrics> metrics;
  if (options.metrics) {
    auto served = WorkerMetrics::serve(*options.metrics, worker, jobs::version_of(*engine));
    if (!served) {
      const bool is_usage = served.problems().front().code == "usage";
      return fail(served.problems(), is_usage ? exit_usage : exit_try_again);
    }
    metrics.emplace(*std::move(served));
  }
  if (const auto started = worker.start(); !started) return fail_at_queue(started.error());
  write_at_once(STDOUT_FILENO, "Dini computes for " + address->text() + " as " + worker.name() + ", engine " +
                                   jobs::queue_identity(*engine) + "\n");
  signals.wait();
  spdlog::info("draining");
  return exit_ok;
}

}  // namespace

void add_worker(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand("worker", "Compute sweeps of servers that have the same --queue");
  command->footer(
      "dini worker --queue redis://:secret@10.0.0.5:6379 --threads 8\n"
      "Ends with 0 when it was told to, 2 when it would fail again in the same way, 75 when it may be tried again.");
  const auto options = std::make_shared<WorkerOptions>();
  Configuration& configuration = options->configuration.emplace(*command);
  configuration.hide(command->add_option("--queue", options->queue,
                                         std::string("The Redis that gives the work, as ") + queue_form +
                                             "; workers compute for servers of the same version and limits"));
  configuration.usual(
      command
          ->add_option("--silent-milliseconds", options->silence,
                       "Without a heartbeat for so long, a worker's variants are given to others (default 15000)")
          ->check(CLI::Range(std::uint64_t{3'000}, std::uint64_t{3'600'000})),
      std::to_string(options->silence));
  command->add_option(
      "--metrics", options->metrics,
      "Tell Prometheus at http://HOST:PORT/metrics what the worker does; a PORT alone is one of 127.0.0.1");
  options->computing.add_options(*command);
  add_limit_options(*command, configuration, options->limits);
  configuration.name_variables();
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli

#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/given_queue.h"
#include "cli/problems.h"
#include "cli/terminal.h"
#include "queue/dead_tasks.h"

namespace dini::cli {
namespace {

using Act = int (*)(queue::Connection&, const std::string&);

struct QueueOptions {
  std::string queue;
  std::string entry;
};

int none(const std::string& entry) {
  return fail({usage_problem("no dead variant is called '" + entry + "'; see dini queue dead")}, exit_usage);
}

int show(queue::Connection& connection, const std::string&) {
  const auto states = queue::queue_states(connection);
  if (!states) return fail_at_queue(states.error());
  if (states->empty()) std::cout << "nothing was ever given to this queue\n";
  for (const queue::QueueState& state : *states) {
    std::cout << printable(state.identity) << ": " << state.workers << " workers, " << state.sweeps << " sweeps, "
              << state.interactive << " interactive variants and " << state.batch << " of jobs, " << state.dead
              << " dead; " << state.counted << " done, " << state.again << " given again, " << state.twice
              << " done twice\n";
  }
  return exit_ok;
}

int dead(queue::Connection& connection, const std::string&) {
  const auto tasks = queue::dead_tasks(connection);
  if (!tasks) return fail_at_queue(tasks.error());
  for (const queue::DeadTask& task : *tasks) {
    std::cout << printable(task.entry + " variant " + task.index + " of sweep " + task.sweep + ", given to " +
                           task.deliveries + " workers, the last one " + task.worker + ", engine " + task.identity)
              << "\n";
  }
  return exit_ok;
}

int retry(queue::Connection& connection, const std::string& entry) {
  const auto retried = queue::retry(connection, entry);
  if (!retried) return fail_at_queue(retried.error());
  if (*retried == queue::Retried::none) return none(entry);
  std::cout << (*retried == queue::Retried::again ? "it is computed again\n"
                                                  : "its sweep has its line already; it is computed when it is asked "
                                                    "for again\n");
  return exit_ok;
}

int drop(queue::Connection& connection, const std::string& entry) {
  const auto dropped = queue::drop_dead(connection, entry);
  if (!dropped) return fail_at_queue(dropped.error());
  return *dropped ? exit_ok : none(entry);
}

int run(const QueueOptions& options, Act act) {
  const auto address = read_queue(options.queue);
  if (!address) return fail(address.problems(), exit_usage);
  constexpr queue::Patience patience{std::chrono::milliseconds(2000), std::chrono::milliseconds(5000)};
  queue::Connection connection(*address, patience);
  return act(connection, options.entry);
}

}  // namespace

void add_queue(CLI::App& program, Command& chosen) {
  auto* command = program.add_subcommand("queue", "Look at the queue before the workers, and at what ended them");
  command->require_subcommand(1);
  command->footer("dini queue dead --queue redis://127.0.0.1:6379");
  const auto options = std::make_shared<QueueOptions>();
  const auto add = [&](const char* name, const char* doc, Act act, bool has_entry) {
    auto* subcommand = command->add_subcommand(name, doc);
    subcommand->add_option("--queue", options->queue, std::string("The Redis, as ") + queue_form)
        ->envname("DINI_QUEUE")
        ->required();
    if (has_entry) subcommand->add_option("entry", options->entry, "As `dini queue dead` calls it")->required();
    subcommand->callback([options, act, &chosen] { chosen = [options, act] { return run(*options, act); }; });
  };
  add("show", "Tell what lies in it, by engine", show, false);
  add("dead", "List the variants that ended as many workers as they may", dead, false);
  add("retry", "Let one of these be computed again", retry, true);
  add("drop", "Take one of these off the list", drop, true);
}

}  // namespace dini::cli

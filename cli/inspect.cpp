#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/computing.h"
#include "cli/exit_codes.h"
#include "cli/given_graph.h"
#include "cli/problems.h"

namespace dini::cli {
namespace {

struct InspectOptions {
  GraphArguments graph;
  std::string place;
  bool full = false;
  Computing computing;
};

int run(InspectOptions& options, const EngineMaker& make_engine) {
  const Console& console = options.graph.console();
  if (const Problems wrong = options.computing.apply(); !wrong.empty()) return console.fail(wrong, exit_usage);
  const auto dot = options.place.find('.');
  if (dot == 0 || options.place.empty() || dot + 1 == options.place.size()) {
    return console.fail({usage_problem("the place to inspect is NODE or NODE.OUTPUT, not '" + options.place + "'")},
                        exit_usage);
  }
  const auto given = options.graph.load(make_engine);
  if (!given) return given.error();
  const InspectRequest request{.graph = given->graph,
                               .parameters = given->parameters,
                               .node = options.place.substr(0, dot),
                               .output = dot == std::string::npos ? "" : options.place.substr(dot + 1),
                               .full = options.full};
  // `inspect` checks and evaluates in one call; a graph that checks out can only have failed while being evaluated.
  const auto value = given->engine->inspect(request, Job());
  if (!value) {
    const auto verdict = given->engine->validate(*given->graph, given->parameters, Cancel(), Sent::document);
    const bool valid = verdict && verdict->value("valid", false);
    const int code = exit_code_for(value.problems(), valid ? Stage::evaluating : Stage::checking);
    return console.fail(value.problems(), code, &given->source);
  }
  std::cout << Json::parse(**value).dump(2) << "\n";
  return exit_ok;
}

}  // namespace

void add_inspect(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand("inspect", "Print the value on a wire, in full double precision, as JSON");
  const auto options = std::make_shared<InspectOptions>();
  options->graph.add_options(*command);
  command->add_option("place", options->place, "NODE or NODE.OUTPUT")->required();
  command->add_flag("--full", options->full, "Meshes with all positions and indices");
  options->graph.add_json_option(*command, "Answer as JSON also when something is wrong");
  options->computing.add_options(*command);
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli

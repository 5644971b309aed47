#include <iostream>
#include <memory>

#include "cli/assets.h"
#include "cli/commands.h"
#include "cli/computing.h"
#include "cli/documents.h"
#include "cli/exit_codes.h"
#include "cli/terminal.h"

namespace dini::cli {
namespace {

struct Options {
  std::string graph;
  std::string place;
  std::vector<std::string> settings;
  bool full = false;
  Assets assets;
  Computing computing;
};

int run(Options& options, const EngineMaker& make_engine) {
  if (const Problems wrong = options.computing.apply(); !wrong.empty()) return fail(wrong, exit_usage);
  const Limits limits;
  const auto parameters = read_settings(options.settings, limits);
  if (!parameters) return fail(parameters.problems(), exit_usage);
  const auto document = read_graph(options.graph, limits);
  if (!document) return fail(document.problems(), exit_code_for(document.problems(), Stage::checking));

  const auto dot = options.place.find('.');
  if (dot == 0 || options.place.empty() || dot + 1 == options.place.size()) {
    return fail(
        {{.code = "usage", .detail = "the place to inspect is NODE or NODE.OUTPUT, not '" + options.place + "'"}},
        exit_usage);
  }
  const std::unique_ptr<Engine> engine = make_engine(limits);
  const InspectRequest request{.graph = engine->read(*document),
                               .parameters = *parameters,
                               .node = options.place.substr(0, dot),
                               .output = dot == std::string::npos ? "" : options.place.substr(dot + 1),
                               .full = options.full};
  if (const Problems wrong = options.assets.give_to(*engine, Cancel()); !wrong.empty()) {
    return fail(wrong, exit_code_for(wrong, Stage::checking));
  }
  // `inspect` checks and evaluates in one call; a graph that checks out can only have failed while being evaluated.
  const auto value = engine->inspect(request, Job());
  if (!value) {
    const auto verdict = engine->validate(*request.graph, request.parameters, Cancel(), Sent::document);
    const bool valid = verdict && verdict->value("valid", false);
    return fail(value.problems(), exit_code_for(value.problems(), valid ? Stage::evaluating : Stage::checking));
  }
  std::cout << Json::parse(**value).dump(2) << "\n";
  return exit_ok;
}

}  // namespace

void add_inspect(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand("inspect", "Print the value on a wire, in full double precision, as JSON");
  const auto options = std::make_shared<Options>();
  command->add_option("graph", options->graph, "The graph document, or - for standard input")->required();
  command->add_option("place", options->place, "NODE or NODE.OUTPUT")->required();
  command->add_option("--set", options->settings, "A parameter as name=value; may be repeated")
      ->allow_extra_args(false);
  command->add_flag("--full", options->full, "Meshes with all positions and indices");
  options->assets.add_option(*command);
  options->computing.add_options(*command);
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli

#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/given_graph.h"
#include "cli/quality_option.h"
#include "service/version.h"

namespace dini::cli {
namespace {

struct HashOptions {
  GraphArguments graph;
  std::string output;
  std::string format;
  QualityOption quality;
};

/// The outputs whose tags are told: the one asked for, else all.
Result<std::vector<std::string>> outputs_of(const HashOptions& options, const GivenGraph& given) {
  if (!options.output.empty()) return std::vector{options.output};
  const auto interface = given.engine->interface(*given.graph);
  if (!interface) return interface.problems();
  return interface->value("outputs", std::vector<std::string>());
}

void print_hashes(const Json& told) {
  std::cout << "engine " << told["engine"].get<std::string>() << "\ngraph " << told["graph"].get<std::string>() << "\n";
  for (const auto& [output, tag] : told["outputs"].items()) {
    std::cout << printable(output) << " " << tag.get<std::string>() << "\n";
  }
}

int run(const HashOptions& options, const EngineMaker& make_engine) {
  const auto given = options.graph.load(make_engine);
  if (!given) return given.error();
  const auto failed = [&](const Problems& problems) {
    return options.graph.console().fail(problems, exit_code_for(problems, Stage::checking), &given->source);
  };
  const auto outputs = outputs_of(options, *given);
  if (!outputs) return failed(outputs.problems());
  Json tags = Json::object();
  // A graph without outputs is asked for the usual one all the same, which says what it lacks.
  for (const std::string& output : outputs->empty() ? std::vector<std::string>{""} : *outputs) {
    const auto prepared = given->engine->prepare({.graph = given->graph,
                                                  .parameters = given->parameters,
                                                  .output = output,
                                                  .quality = options.quality.value(),
                                                  .format = options.format},
                                                 Cancel());
    if (!prepared) return failed(prepared.problems());
    tags[(*prepared)->output] = (*prepared)->model_tag;
  }
  const Json told = {{"engine", engine_version}, {"graph", to_hex(given->graph->hash)}, {"outputs", std::move(tags)}};
  if (options.graph.console().json()) {
    std::cout << told.dump(2) << "\n";
  } else {
    print_hashes(told);
  }
  return exit_ok;
}

}  // namespace

void add_hash(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand(
      "hash",
      "Print the hash of a graph and the entity tag of each output, without evaluating: equal tags mean equal files");
  command->footer("dini hash ring.json --set reach=2");
  const auto options = std::make_shared<HashOptions>();
  options->graph.add_options(*command);
  command->add_option("--output", options->output, "The export node (default: all)");
  command->add_option("--format", options->format, "The format of the files (default: glb)");
  options->quality.add_option(*command);
  options->graph.add_json_option(*command, "Answer as JSON");
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli

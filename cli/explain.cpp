#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/given_graph.h"
#include "cli/quality_option.h"

namespace dini::cli {
namespace {

struct ExplainOptions {
  GraphArguments graph;
  std::string output;
  std::vector<std::string> preview;
  QualityOption quality;
};

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

std::string work_text(double nanoseconds) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << nanoseconds / 1e6 << " ms";
  return text.str();
}

/// A line for the whole, and one for each node with what it would take, by id.
void print_explained(const Json& explained) {
  std::cout << explained["runs"] << " nodes run, about " << work_text(explained["work"].get<double>())
            << " of one processor and at most " << explained["bytes"] << " bytes\n";
  std::size_t id_width = 0, type_width = 0;
  for (const auto& [id, node] : explained["nodes"].items()) {
    id_width = std::max(id_width, id.size());
    type_width = std::max(type_width, node.value("type", "").size());
  }
  for (const auto& [id, node] : explained["nodes"].items()) {
    const std::string state = node.value("state", "");
    std::cout << padded(printable(id), id_width) << "  " << padded(node.value("type", ""), type_width) << "  " << state;
    if (state == "runs") {
      std::cout << "  " << work_text(node["work"].get<double>()) << "  " << node["bytes"] << " bytes";
    }
    std::cout << "\n";
  }
}

int run(const ExplainOptions& options, const EngineMaker& make_engine) {
  const auto given = options.graph.load(make_engine);
  if (!given) return given.error();
  const auto prepared = given->engine->prepare({.graph = given->graph,
                                                .parameters = given->parameters,
                                                .output = options.output,
                                                .quality = options.quality.value(),
                                                .preview = options.preview},
                                               Cancel());
  if (!prepared) {
    return options.graph.console().fail(prepared.problems(), exit_code_for(prepared.problems(), Stage::checking),
                                        &given->source);
  }
  const Json explained = given->engine->explain(**prepared);
  if (options.graph.console().json()) {
    std::cout << explained.dump(2) << "\n";
  } else {
    print_explained(explained);
  }
  return exit_ok;
}

}  // namespace

void add_explain(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand(
      "explain", "Tell which nodes an evaluation would run, with predicted time and memory, without evaluating");
  const auto options = std::make_shared<ExplainOptions>();
  options->graph.add_options(*command);
  auto* output = command->add_option("--output", options->output, "The export node (default: the only one)");
  command->add_option("--preview", options->preview, "A node, or node.output, to draw instead; may be repeated")
      ->allow_extra_args(false)
      ->excludes(output);
  options->quality.add_option(*command);
  options->graph.add_json_option(*command, "Answer as JSON, the schema `Explanation` of docs/http.md");
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli

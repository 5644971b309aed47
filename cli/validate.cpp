#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/evaluation.h"
#include "cli/exit_codes.h"
#include "cli/given_graph.h"

namespace dini::cli {
namespace {

struct ValidateOptions {
  GraphArguments graph;
};

/// `valid (3 nodes, 12 bytes)`
void print_valid(const Json& verdict) {
  std::string cost;
  const Json predicted = verdict.value("cost", Json::object());
  for (const auto& [name, amount] : predicted.items()) {
    cost += (cost.empty() ? " (" : ", ") + amount.dump() + " " + name;
  }
  std::cout << "valid" << printable(cost) << (cost.empty() ? "" : ")") << "\n";
}

int run(const ValidateOptions& options, const EngineMaker& make_engine) {
  const auto given = options.graph.load(make_engine);
  if (!given) return given.error();
  // As if in a request: only so the pointers tell what is wrong with the graph from what is wrong with the parameters.
  auto verdict = given->engine->validate(*given->graph, given->parameters, Cancel(), Sent::request);
  if (!verdict) return options.graph.console().fail(verdict.problems(), exit_limit, &given->source);
  const bool valid = verdict->value("valid", false);
  const Problems problems = problems_of_request(verdict->value("errors", Json::array()));
  if (options.graph.console().json()) {
    (*verdict)["errors"] = problems_json(problems, &given->source);
    std::cout << written(*verdict);
  } else if (valid) {
    print_valid(*verdict);
  } else {
    options.graph.console().problems(problems, &given->source);
  }
  return valid ? exit_ok : exit_invalid_graph;
}

}  // namespace

void add_validate(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command =
      program.add_subcommand("validate", "List everything that is wrong with a graph, without evaluating it");
  const auto options = std::make_shared<ValidateOptions>();
  options->graph.add_options(*command);
  options->graph.add_json_option(*command, "Answer as JSON, with types, axes and predicted cost");
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli

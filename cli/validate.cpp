#include <iostream>
#include <memory>

#include "cli/assets.h"
#include "cli/commands.h"
#include "cli/documents.h"
#include "cli/exit_codes.h"
#include "cli/terminal.h"

namespace dini::cli {
namespace {

struct Options {
  std::string graph;
  std::vector<std::string> settings;
  bool json = false;
  Assets assets;
};

void print_verdict(const Json& verdict) {
  for (const Json& error : verdict.value("errors", Json::array())) std::cout << problem_line(error) << "\n";
  if (!verdict.value("valid", false)) return;
  std::string cost;
  const Json predicted = verdict.value("cost", Json::object());
  for (const auto& [name, amount] : predicted.items()) {
    cost += (cost.empty() ? " (" : ", ") + amount.dump() + " " + name;
  }
  std::cout << "valid" << printable(cost) << (cost.empty() ? "" : ")") << "\n";
}

int run(const Options& options, const EngineMaker& make_engine) {
  const Limits limits;
  const auto parameters = read_settings(options.settings, limits);
  if (!parameters) return fail(parameters.problems(), exit_usage);
  const auto document = read_graph(options.graph, limits);
  if (!document) return fail(document.problems(), exit_code_for(document.problems(), Stage::checking));
  const std::unique_ptr<Engine> engine = make_engine(limits);
  if (const Problems wrong = options.assets.give_to(*engine, Cancel()); !wrong.empty()) {
    return fail(wrong, exit_code_for(wrong, Stage::checking));
  }
  const auto checked = engine->validate(*engine->read(*document), *parameters, Cancel(), Sent::document);
  if (!checked) return fail(checked.problems(), exit_limit);
  const Json& verdict = *checked;
  if (options.json) {
    std::cout << verdict.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
  } else {
    print_verdict(verdict);
  }
  return verdict.value("valid", false) ? exit_ok : exit_invalid_graph;
}

}  // namespace

void add_validate(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command =
      program.add_subcommand("validate", "List everything that is wrong with a graph, without evaluating it");
  const auto options = std::make_shared<Options>();
  command->add_option("graph", options->graph, "The graph document, or - for standard input")->required();
  command->add_option("--set", options->settings, "A parameter as name=value; may be repeated")
      ->allow_extra_args(false);
  options->assets.add_option(*command);
  command->add_flag("--json", options->json, "Answer as JSON, with types, axes and predicted cost");
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli

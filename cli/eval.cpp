#include <iostream>
#include <memory>
#include <optional>

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
  std::vector<std::string> settings;
  std::string model;
  std::string report;
  std::string output;
  std::string quality = "final";
  std::optional<std::int64_t> triangle_budget;
  std::vector<std::string> preview;
  std::size_t deadline_ms = 0;
  Assets assets;
  Computing computing;
};

int fail(const Problems& problems, int code) {
  print_problems(problems);
  return code;
}

/// False when a check of the report did not pass; says which.
bool checks_hold(const Json& report) {
  bool hold = true;
  for (const Json& check : report.value("checks", Json::array())) {
    if (check.value("passed", true)) continue;
    hold = false;
    const Problem problem{
        .code = "check-failed", .detail = check.value("message", ""), .node = check.value("node", "")};
    print_problems({problem});
  }
  return hold;
}

/// `out: 1234 bytes, 10 vertices, 12 triangles`
std::string summary(const Json& report) {
  const bool preview = !report.contains("model");
  const Json model = report.value(preview ? "preview" : "model", Json::object());
  std::string text = report.value("output", "preview") + ":";
  for (const auto* measure : {"bytes", "vertices", "triangles"}) {
    if (model.contains(measure)) text += (text.back() == ':' ? " " : ", ") + model.at(measure).dump() + " " + measure;
  }
  return printable(text);
}

int run(Options& options) {
  if (const Problems wrong = options.computing.apply(); !wrong.empty()) return fail(wrong, exit_usage);
  if (options.model == "-" && options.report == "-") {
    return fail({{.code = "usage", .detail = "-o and --report cannot both be standard output"}}, exit_usage);
  }
  if (const Problems wrong = unwritable({options.model, options.report}, options.graph); !wrong.empty()) {
    return fail(wrong, exit_code_for(wrong, Stage::checking));
  }
  Limits limits;
  // Nobody waits at the other end of a script, so a deadline is kept only when one is asked for.
  const Cancel cancel(options.deadline_ms == 0 ? Cancel::Clock::time_point::max()
                                               : Cancel::Clock::now() + std::chrono::milliseconds(options.deadline_ms));
  const auto parameters = read_settings(options.settings, limits);
  if (!parameters) return fail(parameters.problems(), exit_usage);
  const auto graph = read_graph(options.graph, limits);
  if (!graph) return fail(graph.problems(), exit_code_for(graph.problems(), Stage::checking));

  const Engine engine(limits);
  if (const Problems wrong = options.assets.give_to(engine, cancel); !wrong.empty()) {
    return fail(wrong, exit_code_for(wrong, Stage::checking));
  }
  const auto prepared = engine.prepare({.graph = *graph,
                                        .parameters = *parameters,
                                        .output = options.output,
                                        .quality = options.quality == "draft" ? Quality::draft : Quality::final,
                                        .triangle_budget = options.triangle_budget,
                                        .preview = options.preview});
  if (!prepared) return fail(prepared.problems(), exit_code_for(prepared.problems(), Stage::checking));
  const auto evaluated = engine.evaluate(**prepared, cancel);
  if (!evaluated) return fail(evaluated.problems(), exit_code_for(evaluated.problems(), Stage::evaluating));

  const Json report = evaluated->report();
  for (const Json& warning : report.value("warnings", Json::array())) {
    std::cerr << printable("warning[" + warning.value("code", "") + "] " + warning.value("node", "") + ": " +
                           warning.value("detail", ""))
              << "\n";
  }
  if (!options.report.empty()) {
    const std::string text = report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    if (const Problems wrong = write_output(options.report, text); !wrong.empty()) return fail(wrong, exit_io);
  }
  if (options.model.empty() && options.report != "-") std::cout << summary(report) << "\n";
  // A check that fails is an answer about this model, so the model is written all the same.
  if (!options.model.empty()) {
    const std::string& file = evaluated->glb != nullptr ? *evaluated->glb : *evaluated->preview;
    if (const Problems wrong = write_output(options.model, file); !wrong.empty()) return fail(wrong, exit_io);
  }
  return checks_hold(report) ? exit_ok : exit_check_failed;
}

}  // namespace

void add_eval(CLI::App& program, Command& chosen) {
  auto* command = program.add_subcommand("eval", "Evaluate a graph into a GLB file");
  const auto options = std::make_shared<Options>();
  command->add_option("graph", options->graph, "The graph document, or - for standard input")->required();
  command->add_option("--set", options->settings, "A parameter as name=value; may be repeated")
      ->allow_extra_args(false);
  command->add_option("-o,--out", options->model,
                      "Where the model goes, or - for standard output; without it the model is only described");
  command->add_option("--report", options->report, "Where the JSON report goes, or - for standard output");
  auto* output = command->add_option("--output", options->output, "The export node (default: the only one)");
  command
      ->add_option("--preview", options->preview,
                   "A node, or node.output, to draw with control geometry instead of the model; may be repeated")
      ->allow_extra_args(false)
      ->excludes(output);
  command->add_option("--quality", options->quality, "draft or final (default)")
      ->check(CLI::IsMember({"draft", "final"}));
  command->add_option("--triangle-budget", options->triangle_budget, "About how many triangles a draft has");
  command->add_option("--deadline-ms", options->deadline_ms, "Give up after this many milliseconds")
      ->check(CLI::Range(std::size_t{1}, std::size_t{86'400'000}));
  options->assets.add_option(*command);
  options->computing.add_options(*command);
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace dini::cli

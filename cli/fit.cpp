#include "fitting/fit.h"

#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/computing.h"
#include "cli/documents.h"
#include "cli/evaluation.h"
#include "cli/exit_codes.h"
#include "cli/fitting/words.h"
#include "cli/given_graph.h"
#include "cli/layout.h"
#include "cli/output_files.h"

namespace dini::cli {
namespace {

struct FitOptions {
  GraphArguments graph;
  FitWords words;
  std::optional<std::string> target_mesh, out, report;
  std::string mesh;
  std::vector<std::string> minimize;
  std::int64_t starts = FitRequest().starts;
  std::int64_t evaluations = FitRequest().evaluations;
  std::size_t deadline_ms = 0;
  bool quiet = false;
  Computing computing;
};

/// Gives the file to the engine; its hash.
Result<std::string> added_mesh(const std::string& path, const Engine& engine) {
  const auto bytes = read_input(path, engine.limits().asset_bytes);
  if (!bytes) return bytes.problems();
  const auto added = engine.add_asset(*bytes, "", Cancel());
  if (added) return added->sha256;
  Problems problems = added.problems();
  problems.front().detail = path + ": " + problems.front().detail;
  return problems;
}

Result<FitRequest> request_of(const FitOptions& options, const GivenGraph& given) {
  FitRequest request{.graph = given.graph,
                     .parameters = given.parameters,
                     .mesh = options.mesh,
                     .minimize = options.minimize,
                     .starts = options.starts,
                     .evaluations = options.evaluations};
  auto vary = options.words.vary();
  if (!vary) return vary.problems();
  auto targets = options.words.targets(given.engine->limits());
  if (!targets) return targets.problems();
  request.vary = *std::move(vary);
  request.targets = *std::move(targets);
  if (options.target_mesh) {
    auto mesh = added_mesh(*options.target_mesh, *given.engine);
    if (!mesh) return mesh.problems();
    request.target_mesh = *std::move(mesh);
  }
  return request;
}

int code_of(const Json& found) {
  const std::string outcome = found.at("outcome").get<std::string>();
  if (outcome == "converged") return exit_ok;
  return outcome == "conditions" ? exit_check_failed : exit_limit;
}

/// A line for each thing that is worth knowing.
std::string summary_of_fit(const Json& found) {
  std::string text, list;
  const auto line = [&](const std::string& words) { text += printable(words) + "\n"; };
  for (const auto& [name, value] : found.at("parameters").items()) {
    list += (list.empty() ? "" : ", ") + name + "=" + dump(value);
  }
  line(list);
  for (const auto& [place, target] : found.at("targets").items()) {
    line(place + ": " + dump(target.at("found")) + ", wanted is " + dump(target.at("wanted")));
  }
  for (const auto& [place, value] : found.at("minimized").items()) line(place + ": " + dump(value));
  if (found.contains("distance")) {
    line("distance: " + dump(found["distance"]["root_mean_square"]) + " m (root mean square), at most " +
         dump(found["distance"]["largest"]) + " m");
  }
  for (const Json& each : found.at("undetermined")) line(each.at("detail").get<std::string>());
  for (const Json& name : found.at("at_bounds")) line(name.get<std::string>() + " is at the end of its bounds");
  const std::string outcome = found.at("outcome").get<std::string>();
  if (outcome == "deadline") line("the time was over before the search came to its end");
  if (outcome == "evaluations") line("all evaluations were made before the search came to its end");
  if (outcome == "conditions") line("nothing was found that keeps all targets");
  return text;
}

/// Every report says whether the fit succeeded, and what was wrong where it did not.
int write_report(const FitOptions& options, Json report, const Problems& problems, const SourceText* source, int code) {
  if (!options.report) return code;
  report["succeeded"] = code == exit_ok;
  report["errors"] = problems_json(problems, source);
  const Problems wrong = write_output(*options.report, written(report));
  return wrong.empty() ? code : options.graph.console().fail(wrong, code == exit_ok ? exit_io : code);
}

/// The values that were given are part of what was found: without them the graph would be another one.
Json fitted(const GivenGraph& given, const Json& found) {
  Json parameters = given.parameters;
  parameters.update(found.at("parameters"));
  return fitting::with_defaults(given.document, parameters);
}

int write(const FitOptions& options, const GivenGraph& given, const Json& found) {
  int code = code_of(found);
  Problems wrong;
  if (options.out) wrong = write_output(*options.out, canonical_layout(dump(fitted(given, found))));
  if (!wrong.empty()) code = options.graph.console().fail(wrong, exit_io);
  if (!options.quiet && options.out != "-" && options.report != "-") std::cout << summary_of_fit(found);
  return write_report(options, found, wrong, nullptr, code);
}

int run(FitOptions& options, const EngineMaker& make_engine) {
  const Console& console = options.graph.console();
  const auto refused = [&](const Problems& problems) {
    return console.fail(problems, exit_code_for(problems, Stage::checking));
  };
  if (const Problems wrong = options.computing.apply(); !wrong.empty()) return refused(wrong);
  std::vector<std::string> inputs = {options.graph.path()};
  if (options.target_mesh) inputs.push_back(*options.target_mesh);
  if (const Problems wrong = read_twice("", inputs); !wrong.empty()) return refused(wrong);
  const std::vector<OutputPath> outputs = {{"-o", options.out}, {"--report", options.report, OutputKind::report}};
  if (const Problems unfit = unwritable(outputs, inputs); !unfit.empty()) return refused(unfit);
  if (options.report) remove_file(*options.report);
  Problems unread;
  const auto given =
      options.graph.load(make_engine, [&](const Problems& problems, const SourceText*) { unread = problems; });
  if (!given) return write_report(options, Json::object(), unread, nullptr, given.error());
  const auto failed = [&](const Problems& problems, const SourceText* source) {
    const int code = console.fail(problems, exit_code_for(problems, Stage::checking), source);
    return write_report(options, Json::object(), problems, source, code);
  };
  const auto request = request_of(options, *given);
  if (!request) return failed(request.problems(), nullptr);
  const auto found = fitting::fit(*given->engine, *request, job_within(options.deadline_ms));
  if (!found) return failed(found.problems(), &given->source);
  return write(options, *given, *found);
}

}  // namespace

void add_fit(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand("fit", "Find the values of parameters by what is to come of them");
  command->footer(
      "dini fit ring.json --vary reach,height=0.2:3 --target-mesh scan.ply -o best.json\n"
      "dini fit box.json --vary width,depth --target mass.volume=0.8 --minimize mass.area --report fit.json");
  const auto options = std::make_shared<FitOptions>();
  options->graph.add_options(*command);
  options->words.add_options(*command);
  command->add_option("--target-mesh", options->target_mesh,
                      "A mesh file (OBJ, PLY, STL or GLB) that the model is to be like, or - for standard input");
  command->add_option("--mesh", options->mesh,
                      "The node, or node.output, that is to be like it (default: the one that is exported)");
  command
      ->add_option("--minimize", options->minimize,
                   "A node, or node.output, whose number is to be as small as it can; then targets are conditions. May "
                   "be repeated")
      ->allow_extra_args(false);
  command
      ->add_option("--starts", options->starts,
                   "From how many places the search begins (default: 4): the given one, and the best of others")
      ->check(CLI::Range(std::int64_t{1}, FitRequest::most_starts));
  command->add_option("--evaluations", options->evaluations, "How often the graph is evaluated at most (default: 5000)")
      ->check(CLI::Range(std::int64_t{1}, FitRequest::most_evaluations));
  constexpr std::size_t most_milliseconds = 86'400'000;
  command->add_option("--deadline-ms", options->deadline_ms, "End with the best so far after this many milliseconds")
      ->check(CLI::Range(std::size_t{1}, most_milliseconds));
  command->add_option("-o,--out", options->out,
                      "Where the graph goes with what was found as defaults of its parameters, or - for standard "
                      "output");
  command->add_option("--report", options->report,
                      "Where everything that was found goes as JSON, or - for standard output");
  command->add_flag("-q,--quiet", options->quiet, "Say nothing on standard output");
  options->computing.add_options(*command);
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli

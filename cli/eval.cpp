#include <iostream>
#include <memory>
#include <optional>

#include "cli/assets.h"
#include "cli/commands.h"
#include "cli/documents.h"
#include "cli/eval_targets.h"
#include "cli/evaluation.h"
#include "cli/exit_codes.h"
#include "cli/in_order.h"
#include "cli/output_files.h"
#include "cli/quality_option.h"
#include "cli/run_options.h"
#include "cli/terminal.h"

namespace dini::cli {
namespace {

struct EvalOptions {
  std::vector<std::string> graphs;
  std::vector<std::string> settings;
  std::vector<std::string> outputs;
  std::optional<std::string> report;
  std::string output;
  std::string format;
  bool make_folders = false;
  bool no_draco = false;
  bool embed_graph = false;
  bool parts = false;
  QualityOption quality;
  std::optional<std::int64_t> triangle_budget;
  std::vector<std::string> preview;
  RunOptions running;
  bool quiet = false;
  bool verbose = false;
  Assets assets;
  Console console;
};

/// One file to make, or what keeps it from being made.
struct EvalWork {
  const EvalGraph* graph = nullptr;
  const EvalTarget* target = nullptr;
};

EvaluateRequest request_of(const EvalOptions& options, const Engine& engine, const Json& parameters,
                           const EvalWork& work) {
  return {.graph = engine.read(*work.graph->document),
          .parameters = parameters,
          .output = work.target->output,
          .quality = options.quality.value(),
          .triangle_budget = options.triangle_budget,
          .preview = options.preview,
          .parts = options.parts,
          .format = work.target->format->name,
          .draco = !options.no_draco,
          .embed_graph = options.embed_graph,
          .notes = notes_of(*work.graph->document)};
}

/// Evaluates and writes the file, so that no finished file waits in memory for those before it.
Outcome made(const EvalOptions& options, const Engine& engine, const Json& parameters, const EvalWork& work) {
  if (!work.graph->problems.empty()) return failed(work.graph->problems, work.graph->code);
  Outcome outcome = evaluated(engine, request_of(options, engine, parameters, work), options.running.job());
  if (outcome.code != exit_ok || !work.target->path) return outcome;
  if (Problems wrong = write_output(*work.target->path, *outcome.file->bytes); !wrong.empty()) {
    outcome.code = exit_io;
    outcome.problems = std::move(wrong);
  }
  outcome.file = nullptr;
  return outcome;
}

/// What the whole call came to.
struct Told {
  int code = exit_ok;
  Json runs = Json::array();
};

/// Whether lines about what succeeded have a place on standard output.
bool says_success(const EvalOptions& options, const std::vector<EvalWork>& works) {
  const bool is_taken =
      options.console.json() || options.report == "-" || options.outputs == std::vector<std::string>{"-"};
  return !options.quiet && !is_taken && (works.size() > 1 || options.outputs.empty());
}

void tell(const EvalOptions& options, const EvalWork& work, const Outcome& outcome, bool is_alone, bool says) {
  const SourceText* source = work.graph->source ? &*work.graph->source : nullptr;
  if (!options.console.json()) {
    // A file that cannot be read or written is no fault in the document.
    const bool is_io = outcome.code == exit_io;
    options.console.problems(outcome.problems, is_io ? nullptr : source);
    if (!options.quiet && source != nullptr) options.console.warnings(outcome.report, *source);
  }
  if (options.verbose && outcome.code == exit_ok) {
    std::cerr << printable(work.graph->path) << ":\n" << times_of(outcome.report);
  }
  if (outcome.code != exit_ok || !says) return;
  std::cout << (is_alone ? "" : printable(work.graph->path) + ": ") << summary_of(outcome.report)
            << (work.target->path ? " -> " + printable(*work.target->path) : "") << "\n"
            << parts_of(outcome.report);
}

Told make_all(const EvalOptions& options, const Engine& engine, const Json& parameters,
              const std::vector<EvalWork>& works) {
  Told told;
  FailFast fail_fast(options.running);
  const bool says = says_success(options, works);
  do_in_order<std::optional<Outcome>>(
      works.size(), options.running.at_once(),
      [&](std::size_t index) -> std::optional<Outcome> {
        if (fail_fast.stopped()) return std::nullopt;
        Outcome outcome = made(options, engine, parameters, works[index]);
        fail_fast.after(outcome.code == exit_ok);
        return outcome;
      },
      [&](std::size_t index, std::optional<Outcome> outcome) {
        const EvalWork& work = works[index];
        const SourceText* source = work.graph->source ? &*work.graph->source : nullptr;
        if (outcome) tell(options, work, *outcome, works.size() == 1, says);
        Json run = outcome ? report_of(*outcome, source) : Json{{"succeeded", false}, {"skipped", true}};
        if (works.size() > 1) run["graph"] = work.graph->path;
        told.runs.push_back(std::move(run));
        if (outcome) told.code = std::max(told.code, outcome->code);
      });
  return told;
}

/// One evaluation is reported by itself, several in a list.
int finish(const EvalOptions& options, const Told& told) {
  Json report =
      told.runs.size() == 1 ? told.runs.front() : Json{{"succeeded", told.code == exit_ok}, {"runs", told.runs}};
  const std::string text = written(report);
  if (options.console.json()) std::cout << text;
  if (!options.report) return told.code;
  const Problems wrong = write_output(*options.report, text);
  if (wrong.empty()) return told.code;
  return options.console.fail(wrong, told.code == exit_ok ? exit_io : told.code);
}

int finish_early(const EvalOptions& options, const Problems& problems) {
  if (!options.console.json()) options.console.problems(problems);
  const Outcome outcome = failed(problems, exit_code_for(problems, Stage::checking));
  return finish(options, Told{.code = outcome.code, .runs = Json::array({report_of(outcome, nullptr)})});
}

int run(EvalOptions& options, const EngineMaker& make_engine) {
  const auto refused = [&](const Problems& problems) {
    return options.console.fail(problems, exit_code_for(problems, Stage::checking));
  };
  if (const Problems wrong = options.running.apply(); !wrong.empty()) return refused(wrong);
  std::vector<std::string> inputs = options.assets.paths();
  inputs.insert(inputs.end(), options.graphs.begin(), options.graphs.end());
  if (const Problems wrong = read_twice("", inputs); !wrong.empty()) return refused(wrong);
  const OutputPath report{"--report", options.report, OutputKind::report};
  if (options.make_folders) {
    if (const Problems wrong = make_folders({report}); !wrong.empty()) return refused(wrong);
  }
  if (const Problems unfit = unwritable({report}, inputs); !unfit.empty()) return refused(unfit);
  // A report of an earlier run must not be taken for one of this, however this one ends.
  if (options.report) remove_file(*options.report);
  const Limits limits;
  const auto parameters = read_settings(options.settings, limits);
  if (!parameters) return refused(parameters.problems());

  const std::unique_ptr<Engine> engine = make_engine(limits);
  const auto graphs = eval_graphs(*engine, {.graphs = options.graphs,
                                            .outputs = options.outputs,
                                            .output = options.output,
                                            .format = options.format,
                                            .previews = !options.preview.empty()});
  if (!graphs) return refused(graphs.problems());
  std::vector<EvalWork> works;
  std::vector<OutputPath> files;
  for (const EvalGraph& graph : *graphs) {
    for (const EvalTarget& target : graph.targets) {
      works.push_back({&graph, &target});
      files.push_back({"-o", target.path, OutputKind::model, target.format->extension});
    }
  }
  if (options.make_folders) {
    if (const Problems wrong = make_folders(files); !wrong.empty()) return finish_early(options, wrong);
  }
  files.push_back(report);
  if (options.console.json()) files.push_back({"--json", "-"});
  if (const Problems unfit = unwritable(files, inputs); !unfit.empty()) return refused(unfit);
  std::vector<const Json*> documents;
  for (const EvalGraph& graph : *graphs) {
    if (graph.document) documents.push_back(&*graph.document);
  }
  const Job reading = options.running.job();
  if (const Problems wrong = options.assets.give_to(*engine, documents, reading.cancel); !wrong.empty()) {
    return finish_early(options, wrong);
  }
  return finish(options, make_all(options, *engine, *parameters, works));
}

}  // namespace

void add_eval(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand("eval", "Evaluate graphs into files");
  command->footer(
      "dini eval ring.json --set reach=2 -o ring.glb --report ring.report.json\n"
      "dini eval parts/*.json -o 'out/{graph}.{output}.glb' --mkdir\n"
      "dini eval frame.json -o body=body.glb -o lid=lid.gltf");
  const auto options = std::make_shared<EvalOptions>();
  command->add_option("graphs", options->graphs, "The graph documents, or - for standard input")->required();
  command->add_option("--set", options->settings, "A parameter as name=value, of all graphs; may be repeated")
      ->allow_extra_args(false);
  command
      ->add_option("-o,--out", options->outputs,
                   "Where the model goes, in the format that its name ends with, or - for standard output; {graph} "
                   "and {output} in it stand for the name of the document and for each output, and OUTPUT=FILE may "
                   "be repeated; without it models are only described")
      ->allow_extra_args(false);
  command->add_option("--format", options->format, "The format of the model, whatever its name ends with");
  command->add_flag("--mkdir", options->make_folders, "Make the folders of what is written");
  command->add_flag("--embed-graph", options->embed_graph, "Put the graph document into the file (asset.extras)");
  command->add_option("--report", options->report, "Where the JSON report goes, or - for standard output");
  auto* parts = command->add_flag("--parts", options->parts,
                                  "Tell of each part of the model whether it is watertight, how thin it is, and more");
  auto* no_draco = command->add_flag("--no-draco", options->no_draco,
                                     "Leave meshes uncompressed, for programs that cannot read Draco");
  auto* output = command->add_option("--output", options->output, "The export node (default: the only one)");
  command
      ->add_option("--preview", options->preview,
                   "A node, or node.output, to draw with control geometry instead of the model; may be repeated")
      ->allow_extra_args(false)
      ->excludes(output)
      ->excludes(parts)
      ->excludes(no_draco);
  options->quality.add_option(*command);
  command->add_option("--triangle-budget", options->triangle_budget, "About how many triangles a draft has");
  auto* quiet = command->add_flag("--quiet", options->quiet, "Tell errors only");
  command->add_flag("-v,--verbose", options->verbose, "Tell the time that each node took, on standard error")
      ->excludes(quiet);
  options->console.add_json_option(*command, "Answer with the report instead of lines, also when something is wrong");
  options->running.add_options(*command, "model", "models");
  options->assets.add_option(*command);
  options->console.add_options(*command);
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli

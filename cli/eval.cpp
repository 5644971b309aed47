#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <optional>

#include "cli/assets.h"
#include "cli/commands.h"
#include "cli/computing.h"
#include "cli/documents.h"
#include "cli/exit_codes.h"
#include "cli/terminal.h"
#include "graph/stopped.h"

namespace dini::cli {
namespace {

struct Options {
  std::string graph;
  std::vector<std::string> settings;
  std::optional<std::string> model;
  std::optional<std::string> report;
  std::string output;
  std::string format;
  bool no_draco = false;
  bool embed_graph = false;
  std::string quality = "final";
  std::optional<std::int64_t> triangle_budget;
  std::vector<std::string> preview;
  std::size_t deadline_ms = 0;
  Assets assets;
  Computing computing;
};

/// What an evaluation came to: its report and the file, or why there is none.
struct Outcome {
  int code = exit_ok;
  Problems problems = {};
  Json report = Json::object();
  SharedFile file = nullptr;
};

Outcome failed(const Problems& problems, Stage stage) {
  return {.code = exit_code_for(problems, stage), .problems = problems};
}

Outcome evaluate(const Options& options, const Engine& engine, const FileFormat& format, const Json& parameters) {
  // Nobody waits at the other end of a script, so a deadline is kept only when one is asked for.
  const Job job{Cancel(options.deadline_ms == 0
                           ? Cancel::Clock::time_point::max()
                           : Cancel::Clock::now() + std::chrono::milliseconds(options.deadline_ms))};
  const auto document = read_graph(options.graph, engine.limits());
  if (!document) return failed(document.problems(), Stage::checking);
  if (const Problems wrong = options.assets.give_to(engine, job.cancel); !wrong.empty()) {
    return failed(wrong, Stage::checking);
  }
  const auto prepared = engine.prepare({.graph = engine.read(*document),
                                        .parameters = parameters,
                                        .output = options.output,
                                        .quality = options.quality == "draft" ? Quality::draft : Quality::final,
                                        .triangle_budget = options.triangle_budget,
                                        .preview = options.preview,
                                        .format = format.name,
                                        .draco = !options.no_draco,
                                        .embed_graph = options.embed_graph,
                                        .notes = notes_of(*document)},
                                       job.cancel);
  if (!prepared) return failed(prepared.problems(), Stage::checking);
  const auto computed = engine.compute(**prepared, job);
  if (!computed) return failed(computed.problems(), Stage::evaluating);
  return {.report = engine.report(**prepared, **computed, Sent::document),
          .file = (*computed)->model != nullptr ? (*computed)->model : (*computed)->preview};
}

/// The same when something goes wrong that should not: that too is an outcome to report.
Outcome evaluated(const Options& options, const Engine& engine, const FileFormat& format, const Json& parameters) {
  try {
    return evaluate(options, engine, format, parameters);
  } catch (const std::bad_alloc&) {
    return failed({out_of_memory()}, Stage::evaluating);
  } catch (const std::exception& error) {
    return failed({{.code = "internal", .detail = error.what()}}, Stage::evaluating);
  }
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

void print_warnings(const Json& report) {
  for (const Json& warning : report.value("warnings", Json::array())) {
    std::cerr << printable("warning[" + warning.value("code", "") + "] " + warning.value("node", "") + ": " +
                           warning.value("detail", ""))
              << "\n";
  }
}

/// ".glb (glb), .gltf (gltf)"
std::string list_of(std::span<const FileFormat> formats) {
  std::string text;
  for (const FileFormat& format : formats)
    text += (text.empty() ? "" : ", ") + format.extension + " (" + format.name + ")";
  return text;
}

/// The format that is asked for, else the one that the name of the file ends with; the usual one for a device or pipe.
Result<const FileFormat*> format_of(const Options& options, std::span<const FileFormat> formats) {
  const auto refused = [&](const std::string& said) {
    return Problem{.code = "usage", .detail = said + "; there is " + list_of(formats)};
  };
  const std::string ending =
      options.model && *options.model != "-" ? std::filesystem::path(*options.model).extension().string() : "";
  const FileFormat* format = &formats.front();
  if (!options.format.empty()) {
    format = format_named(formats, options.format);
    if (format == nullptr) return refused("--format " + options.format + " is none that can be written");
  } else if (!ending.empty()) {
    format = format_of_extension(formats, ending);
    if (format == nullptr) {
      return refused("-o " + *options.model + ": " + ending +
                     " is no format that can be written (--format says another)");
    }
  }
  if (format != &formats.front() && !options.preview.empty()) return refused("--preview is written as GLB only");
  return format;
}

/// The report of every outcome says whether it is one of success, so a failed run never leaves one behind that says so.
std::string report_text(const Outcome& outcome) {
  Json report = outcome.report;
  report["succeeded"] = outcome.code == exit_ok;
  report["errors"] = to_json(outcome.problems, Sent::document);
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

int run(Options& options, const EngineMaker& make_engine) {
  if (const Problems wrong = options.computing.apply(); !wrong.empty()) return fail(wrong, exit_usage);
  std::vector<std::string> inputs = options.assets.paths();
  inputs.push_back(options.graph);
  const Problems unfit = unwritable({{"-o", options.model}, {"--report", options.report}}, inputs);
  if (!unfit.empty()) return fail(unfit, exit_code_for(unfit, Stage::checking));
  const Limits limits;
  const auto parameters = read_settings(options.settings, limits);
  if (!parameters) return fail(parameters.problems(), exit_usage);

  const std::unique_ptr<Engine> engine = make_engine(limits);
  const auto format = format_of(options, engine->formats());
  if (!format) return fail(format.problems(), exit_usage);

  // A report of an earlier run must not be taken for one of this, however this one ends.
  if (options.report) remove_file(*options.report);
  Outcome outcome = evaluated(options, *engine, **format, *parameters);
  print_problems(outcome.problems);
  print_warnings(outcome.report);
  if (outcome.code == exit_ok && !options.model && options.report != "-") std::cout << summary(outcome.report) << "\n";
  if (outcome.code == exit_ok && options.model) {
    if (const Problems wrong = write_output(*options.model, *outcome.file->bytes); !wrong.empty()) {
      print_problems(wrong);
      outcome = {.code = exit_io, .problems = wrong, .report = std::move(outcome.report)};
    }
  }
  if (options.report) {
    const Problems wrong = write_output(*options.report, report_text(outcome));
    if (!wrong.empty()) return fail(wrong, outcome.code == exit_ok ? exit_io : outcome.code);
  }
  return outcome.code;
}

}  // namespace

void add_eval(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand("eval", "Evaluate a graph into a file");
  const auto options = std::make_shared<Options>();
  command->add_option("graph", options->graph, "The graph document, or - for standard input")->required();
  command->add_option("--set", options->settings, "A parameter as name=value; may be repeated")
      ->allow_extra_args(false);
  command->add_option(
      "-o,--out", options->model,
      "Where the model goes, in the format that its name ends with, or - for standard output; without it the "
      "model is only described");
  command->add_option("--format", options->format, "The format of the model, whatever its name ends with");
  command->add_flag("--embed-graph", options->embed_graph, "Put the graph document into the file (asset.extras)");
  command->add_option("--report", options->report, "Where the JSON report goes, or - for standard output");
  auto* no_draco = command->add_flag("--no-draco", options->no_draco,
                                     "Leave meshes uncompressed, for programs that cannot read Draco");
  auto* output = command->add_option("--output", options->output, "The export node (default: the only one)");
  command
      ->add_option("--preview", options->preview,
                   "A node, or node.output, to draw with control geometry instead of the model; may be repeated")
      ->allow_extra_args(false)
      ->excludes(output)
      ->excludes(no_draco);
  command->add_option("--quality", options->quality, "draft or final (default)")
      ->check(CLI::IsMember({"draft", "final"}));
  command->add_option("--triangle-budget", options->triangle_budget, "About how many triangles a draft has");
  command->add_option("--deadline-ms", options->deadline_ms, "Give up after this many milliseconds")
      ->check(CLI::Range(std::size_t{1}, std::size_t{86'400'000}));
  options->assets.add_option(*command);
  options->computing.add_options(*command);
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli

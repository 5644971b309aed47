#include <filesystem>
#include <iostream>
#include <memory>
#include <set>

#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/given_graph.h"
#include "cli/in_order.h"
#include "cli/output_files.h"
#include "cli/output_names.h"
#include "cli/problems.h"
#include "cli/quality_option.h"
#include "cli/run_options.h"
#include "cli/sweeping/axes.h"
#include "cli/sweeping/ledger.h"
#include "cli/sweeping/progress.h"
#include "cli/sweeping/table.h"
#include "jobs/sweep_request.h"
#include "service/requests/requests.h"

namespace dini::cli {
namespace {

struct SweepOptions {
  GraphArguments graph;
  std::vector<std::string> grids, lists;
  std::optional<std::string> out, csv, report;
  std::vector<std::string> measures, outputs;
  std::string format;
  QualityOption quality;
  std::size_t index = 0, count = 1;
  bool make_folders = false, quiet = false;
  RunOptions running;
};

/// A variant before it is made, or one output of it where several are asked for.
struct Wanted {
  std::size_t index = 0;
  Json setting;
  std::string output = {};  ///< empty for the only one
  std::optional<std::string> file;
};

/// A sweep, once everything about it is known.
struct Sweeping {
  const SweepOptions& options;
  const GivenGraph& given;
  jobs::SweepRequest request;
  std::vector<Wanted> wanted = {};
  std::optional<Ledger> ledger = {};
};

/// The folder that all files of a pattern have in common.
std::filesystem::path folder_of(const std::string& pattern) {
  return std::filesystem::path(pattern.substr(0, pattern.find('{')) + "x").parent_path();
}

/// The names that files are called by, of a graph, a variant and all its values.
std::map<std::string, std::string> names_of(const std::string& graph, const Wanted& wanted) {
  std::map<std::string, std::string> names = {{"graph", graph_name(graph)}, {"index", std::to_string(wanted.index)}};
  if (!wanted.output.empty()) names["output"] = wanted.output;
  for (const auto& [name, value] : wanted.setting.items()) names[name] = name_of_value(value);
  return names;
}

Result<jobs::SweepRequest> request_of(const SweepOptions& options, const GivenGraph& given) {
  const auto axes = read_axes(options.grids, options.lists, given.engine->limits());
  if (!axes) return axes.problems();
  auto variants = Variants::read({.grid = *axes}, given.parameters, given.engine->limits().sweep_variants);
  if (!variants) {
    Problem problem = variants.problems().front();
    const bool is_limit = problem.code == "limit-exceeded";
    return Problem{.code = is_limit ? problem.code : "usage", .detail = problem.detail};
  }
  const EvaluateRequest base{.graph = given.graph,
                             .parameters = given.parameters,
                             .quality = options.quality.value(),
                             .measures = options.measures,
                             .format = options.format};
  if (!options.outputs.empty()) {
    Problems faults = faults_in_outputs(options.outputs, *given.graph, *given.engine);
    for (Problem& fault : faults) {
      fault = {.code = fault.code == "unknown-output" ? fault.code : "usage", .detail = "--output: " + fault.detail};
    }
    if (!faults.empty()) return faults;
  }
  return jobs::SweepRequest{base, *std::move(variants), options.outputs};
}

/// The format is that of the name, as for one evaluation.
Problems choose_format(jobs::SweepRequest& request, const SweepOptions& options, const Engine& engine) {
  if (!request.base.format.empty() || !options.out) return {};
  const std::string ending = std::filesystem::path(*options.out).extension().string();
  const FileFormat* format = format_of_extension(engine.formats(), ending);
  if (ending.empty() || format != nullptr) {
    if (format != nullptr) request.base.format = format->name;
    return {};
  }
  return {usage_problem("-o " + *options.out + ": " + ending + " is no format that can be written")};
}

/// Those variants that this process makes, with their files.
Result<std::vector<Wanted>> wanted_of(const SweepOptions& options, const jobs::SweepRequest& request) {
  std::vector<Wanted> wanted;
  for (std::size_t index = options.index; index < request.variants.size(); index += options.count) {
    for (const std::string& output : request.outputs_of_variant()) {
      wanted.push_back({.index = index, .setting = request.variants.at(index), .output = output, .file = {}});
    }
  }
  if (!options.out) return wanted;
  std::vector<std::string> known = {"graph", "index"};
  if (!request.outputs.empty()) known.emplace_back("output");
  const Json first = request.variants.at(0);
  for (const auto& [name, value] : first.items()) known.push_back(name);
  const auto names = read_output_names({"./" + *options.out}, known);
  if (!names) return names.problems();
  std::set<std::string> files;
  for (Wanted& each : wanted) {
    each.file = filled(*options.out, names_of(options.graph.path(), each));
    if (files.insert(*each.file).second) continue;
    const std::string all = request.outputs.size() > 1 ? "{index} and {output}" : "{index}, or all of its parameters,";
    return usage_problem("-o " + *options.out + ": " + *each.file +
                         " would be written twice; the name of each variant is its own with " + all + " in it");
  }
  return wanted;
}

SweptVariant swept(const Sweeping& sweeping, const Wanted& wanted) {
  const SweepOptions& options = sweeping.options;
  const Engine& engine = *sweeping.given.engine;
  SweptVariant variant{
      .index = wanted.index, .setting = wanted.setting, .output = wanted.output, .file = wanted.file.value_or("")};
  const EvaluateRequest request = sweeping.request.with(wanted.setting, wanted.output);
  const Job job = options.running.job();
  const auto prepared = engine.prepare(request, job.cancel);
  const std::string tag = prepared ? (*prepared)->report_tag : "";
  if (wanted.file && prepared) {
    if (Json told = sweeping.ledger->find(*wanted.file, tag); !told.is_null()) {
      variant.outcome.report = std::move(told);
      variant.known = true;
      return variant;
    }
  }
  Outcome& outcome = variant.outcome = evaluated(engine, prepared, job);
  if (outcome.code != exit_ok) return variant;
  Json told = Json::object();
  for (const char* member : {"model", "measures", "output", "fingerprint"}) {
    if (outcome.report.contains(member)) told[member] = outcome.report[member];
  }
  outcome.report = told;
  if (!wanted.file) return variant;
  Problems wrong = write_output(*wanted.file, *outcome.file->bytes);
  if (wrong.empty()) wrong = sweeping.ledger->add(*wanted.file, tag, to_hex(outcome.file->sha256), told);
  if (!wrong.empty()) outcome = failed(wrong, exit_io);
  outcome.file = nullptr;
  return variant;
}

/// `reach=0.5, rule=paper`
std::string text_of(const Json& setting) {
  std::string text;
  for (const auto& [name, value] : setting.items()) text += (text.empty() ? "" : ", ") + name + "=" + dump(value);
  return text;
}

void tell(const SweepOptions& options, const SourceText& source, const SweptVariant& variant) {
  Problems problems = variant.outcome.problems;
  for (Problem& problem : problems) {
    const std::string which = options.outputs.size() > 1 ? ", output " + variant.output : "";
    problem.detail = "variant " + std::to_string(variant.index) + " (" + text_of(variant.setting) + ")" + which + ": " +
                     problem.detail;
  }
  options.graph.console().problems(problems, variant.outcome.code == exit_io ? nullptr : &source);
}

std::vector<SweptVariant> sweep(const Sweeping& sweeping) {
  const SweepOptions& options = sweeping.options;
  std::vector<SweptVariant> variants;
  FailFast fail_fast(options.running);
  Progress progress(sweeping.wanted.size(), !options.quiet);
  do_in_order<std::optional<SweptVariant>>(
      sweeping.wanted.size(), options.running.at_once(),
      [&](std::size_t place) -> std::optional<SweptVariant> {
        if (fail_fast.stopped()) return std::nullopt;
        SweptVariant variant = swept(sweeping, sweeping.wanted[place]);
        fail_fast.after(variant.outcome.code == exit_ok);
        return variant;
      },
      [&](std::size_t, std::optional<SweptVariant> variant) {
        if (!variant) return;
        if (!variant->outcome.problems.empty()) progress.clear();
        tell(options, sweeping.given.source, *variant);
        progress.step();
        variants.push_back(*std::move(variant));
      });
  return variants;
}

Json report_of(const std::vector<SweptVariant>& variants, std::size_t wanted, int code, const SourceText& source) {
  Json list = Json::array();
  for (const SweptVariant& variant : variants) {
    Json entry = report_of(variant.outcome, &source);
    entry["index"] = variant.index;
    entry["setting"] = variant.setting;
    entry["known"] = variant.known;
    if (!variant.output.empty()) entry["output"] = variant.output;
    if (!variant.file.empty()) entry["file"] = variant.file;
    list.push_back(std::move(entry));
  }
  return {{"succeeded", code == exit_ok && variants.size() == wanted}, {"variants", std::move(list)}};
}

int finish(const Sweeping& sweeping, const std::vector<SweptVariant>& variants) {
  const SweepOptions& options = sweeping.options;
  int code = exit_ok;
  std::size_t failures = 0, known = 0;
  for (const SweptVariant& variant : variants) {
    code = std::max(code, variant.outcome.code);
    failures += variant.outcome.code != exit_ok ? 1 : 0;
    known += variant.known ? 1 : 0;
  }
  const auto write = [&](const std::optional<std::string>& path, const std::string& text) {
    if (!path) return;
    const Problems wrong = write_output(*path, text);
    if (!wrong.empty()) code = std::max(code, options.graph.console().fail(wrong, exit_io));
  };
  write(options.csv, table_of(variants, options.measures, options.outputs.size() > 1));
  const Json report = report_of(variants, sweeping.wanted.size(), code, sweeping.given.source);
  write(options.report, written(report));
  if (!options.quiet && options.csv != "-" && options.report != "-") {
    std::cout << variants.size() - failures << " of " << sweeping.wanted.size()
              << (options.outputs.size() > 1 ? " models are done" : " variants are done");
    if (known > 0) std::cout << ", " << known << " of them by an earlier run";
    std::cout << "\n";
  }
  return code;
}

int run(SweepOptions& options, const EngineMaker& make_engine) {
  const Console& console = options.graph.console();
  const auto refused = [&](const Problems& problems) {
    return console.fail(problems, exit_code_for(problems, Stage::checking));
  };
  if (const Problems wrong = options.running.apply(); !wrong.empty()) return refused(wrong);
  if (options.index >= options.count) {
    return refused({usage_problem("--index counts from 0 and stays below --count")});
  }
  const std::vector<OutputPath> tables = {{"--csv", options.csv, OutputKind::table},
                                          {"--report", options.report, OutputKind::report}};
  const std::vector<std::string> inputs = {options.graph.path()};
  if (options.make_folders) {
    if (const Problems wrong = make_folders(tables); !wrong.empty()) return refused(wrong);
  }
  if (const Problems unfit = unwritable(tables, inputs); !unfit.empty()) return refused(unfit);
  for (const OutputPath& table : tables) {
    if (table.path) remove_file(*table.path);
  }
  const auto given = options.graph.load(make_engine);
  if (!given) return given.error();
  auto request = request_of(options, *given);
  if (!request) return refused(request.problems());
  if (const Problems wrong = choose_format(*request, options, *given->engine); !wrong.empty()) return refused(wrong);
  auto wanted = wanted_of(options, *request);
  if (!wanted) return refused(wanted.problems());
  Sweeping sweeping{.options = options, .given = *given, .request = *std::move(request), .wanted = *std::move(wanted)};
  if (options.out) {
    std::vector<OutputPath> files;
    const std::string extension = std::filesystem::path(*options.out).extension().string();
    for (const Wanted& each : sweeping.wanted) files.push_back({"-o", each.file, OutputKind::model, extension});
    if (options.make_folders) {
      if (const Problems wrong = make_folders(files); !wrong.empty()) return refused(wrong);
    }
    if (const Problems unfit = unwritable(files, inputs); !unfit.empty()) return refused(unfit);
    sweeping.ledger.emplace(folder_of(*options.out));
  }
  return finish(sweeping, sweep(sweeping));
}

}  // namespace

void add_sweep(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand("sweep", "Evaluate one graph for many values of its parameters");
  command->footer(
      "dini sweep ring.json --grid reach=0:2:9 --list rule=paper,exact -o 'out/{reach}-{rule}.glb' --csv measures.csv "
      "--mkdir\n"
      "dini sweep ring.json --grid reach=0:2:400 -o 'out/{index}.glb' --index 0 --count 4");
  const auto options = std::make_shared<SweepOptions>();
  options->graph.add_options(*command);
  command
      ->add_option("--grid", options->grids,
                   "Numbers of a parameter as NAME=FROM:TO:COUNT, both ends included; may be repeated")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--list", options->lists,
          "Values of a parameter as NAME=VALUE,VALUE,...; may be repeated. All values of all parameters are combined")
      ->allow_extra_args(false);
  command->add_option("-o,--out", options->out,
                      "Where the models go: {NAME} stands for the value of a parameter, {index} for the number of the "
                      "variant, {output} for the export node, {graph} for the name of the document. What is there "
                      "already and right is not made again");
  command->add_option("--format", options->format, "The format of the models, whatever their names end with");
  command->add_option("--csv", options->csv, "Where a table of all variants goes, or - for standard output");
  command->add_option("--report", options->report, "Where the same goes as JSON, or - for standard output");
  command
      ->add_option("--measure", options->measures,
                   "A node, or node.output, whose values the tables tell; may be repeated")
      ->allow_extra_args(false);
  command
      ->add_option("--output", options->outputs,
                   "The export node (default: the only one); may be repeated, with {output} in the names of the files")
      ->allow_extra_args(false);
  options->quality.add_option(*command);
  command->add_option("--index", options->index, "Of --count processes that share the work, which this is, from 0");
  command->add_option("--count", options->count, "How many processes share the work: each makes every COUNTth variant")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}));
  options->running.add_options(*command, "variant", "variants");
  command->add_flag("--mkdir", options->make_folders, "Make the folders of what is written");
  command->add_flag("--quiet", options->quiet, "Tell errors only");
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli

#include <iostream>
#include <memory>

#include "cli/assets.h"
#include "cli/commands.h"
#include "cli/documents.h"
#include "cli/evaluation.h"
#include "cli/exit_codes.h"
#include "cli/in_order.h"
#include "cli/output_files.h"
#include "cli/run_options.h"
#include "cli/terminal.h"
#include "cli/testing/junit.h"
#include "cli/testing/run_case.h"
#include "cli/testing/sarif.h"
#include "cli/testing/stale_golden.h"
#include "cli/testing/summaries.h"

namespace dini::cli {
namespace {

struct TestOptions {
  std::vector<std::string> paths = {"."};
  GoldenOptions golden;
  std::optional<std::string> report, junit, sarif, markdown;
  bool make_folders = false;
  RunOptions running;
  bool quiet = false;
  bool verbose = false;
  Assets assets;
  Console console;

  /// Whether lines for people have a place on standard output.
  bool has_table() const {
    const auto is_output = [](const std::optional<std::string>& path) { return path == "-"; };
    return !console.json() && !is_output(report) && !is_output(junit) && !is_output(sarif) && !is_output(markdown);
  }
};

std::vector<OutputPath> outputs_of(const TestOptions& options) {
  return {{"--report", options.report, OutputKind::report},
          {"--junit", options.junit, OutputKind::xml},
          {"--sarif", options.sarif, OutputKind::log},
          {"--markdown", options.markdown, OutputKind::page}};
}

/// One case of one graph; none for a graph that cannot be tested.
struct TestWork {
  const TestGraph* graph = nullptr;
  const TestCase* asked = nullptr;
};

std::vector<TestWork> works_of(const std::vector<TestGraph>& graphs) {
  std::vector<TestWork> works;
  for (const TestGraph& graph : graphs) {
    if (!graph.can_run()) works.push_back({&graph, nullptr});
    if (!graph.can_run()) continue;
    for (const TestCase& asked : graph.cases) works.push_back({&graph, &asked});
  }
  return works;
}

CaseResult done(const TestOptions& options, const Engine& engine, const TestWork& work) {
  if (work.asked == nullptr) return work.graph->failure;
  return run_case(engine, *work.graph, *work.asked, options.golden, options.running);
}

std::size_t title_width(const std::vector<TestWork>& works) {
  std::size_t width = 0;
  for (const TestWork& work : works) {
    const CaseResult named{.graph = work.graph->found.path, .name = work.asked != nullptr ? work.asked->name : ""};
    width = std::max(width, named.title().size());
  }
  return width;
}

void tell(const TestOptions& options, const CaseResult& result, std::size_t width) {
  if (options.console.json()) return;
  if (options.has_table() && (!options.quiet || !result.passed())) {
    std::cout << table_line(result, width, options.console.colors_output()) << std::endl;
  }
  Problems problems = result.problems;
  for (Problem& problem : problems) {
    if (!result.name.empty()) problem.detail = "case " + result.name + ": " + problem.detail;
  }
  options.console.problems(problems, result.source ? &*result.source : nullptr);
  if (!options.quiet && result.source) options.console.warnings({{"warnings", result.warnings}}, *result.source);
  if (!options.verbose) return;
  for (const auto& [output, made] : result.outputs) std::cerr << times_of(made.report);
}

/// What is left of cases that are no more goes, or fails: golden results and cases are held against each other both
/// ways.
void add_stale(const TestOptions& options, const std::vector<CaseResult>& stale, std::vector<CaseResult>& results) {
  for (const CaseResult& left : stale) {
    const bool says = options.has_table() && !options.quiet;
    if (!options.golden.update) {
      tell(options, left, left.title().size());
      const auto same_graph = [&](const CaseResult& result) { return result.graph == left.graph; };
      const auto last = std::find_if(results.rbegin(), results.rend(), same_graph);
      results.insert(last == results.rend() ? results.end() : last.base(), left);
      continue;
    }
    for (const auto& path : left.stale) {
      remove_file(path);
      if (says) std::cout << "removed  " << printable(path) << "\n";
    }
  }
}

std::vector<CaseResult> all_results(const TestOptions& options, const Engine& engine,
                                    const std::vector<TestWork>& works) {
  std::vector<CaseResult> results;
  FailFast fail_fast(options.running);
  const std::size_t width = title_width(works);
  do_in_order<CaseResult>(
      works.size(), options.running.at_once(),
      [&](std::size_t index) {
        const TestWork& work = works[index];
        if (fail_fast.stopped()) {
          return CaseResult{
              .graph = work.graph->found.path, .name = work.asked != nullptr ? work.asked->name : "", .skipped = true};
        }
        CaseResult result = done(options, engine, work);
        fail_fast.after(result.passed());
        return result;
      },
      [&](std::size_t, CaseResult result) {
        tell(options, result, width);
        results.push_back(std::move(result));
      });
  return results;
}

/// Writes everything that is asked for; the last word of each call.
int finish(const TestOptions& options, const TestRun& begun, const std::vector<CaseResult>& results, int code) {
  const auto write = [&](const std::optional<std::string>& path, const auto& make) {
    if (!path) return;
    const Problems wrong = write_output(*path, make());
    if (!wrong.empty()) code = std::max(code, options.console.fail(wrong, exit_io));
  };
  Json report = test_report_of(results);
  report["succeeded"] = code == exit_ok;
  if (options.console.json()) std::cout << written(report);
  write(options.report, [&] { return written(report); });
  write(options.junit, [&] { return junit_of(results, begun); });
  write(options.sarif, [&] { return written(sarif_of(results)); });
  write(options.markdown, [&] { return test_page_of(results); });
  return code;
}

/// What keeps everything from being tested is reported as the failure of one case.
int finish_early(const TestOptions& options, const TestRun& begun, const Problems& problems) {
  const int code = exit_code_for(problems, Stage::checking);
  if (!options.console.json()) options.console.problems(problems);
  return finish(options, begun, {{.graph = options.paths.front(), .code = code, .problems = problems}}, code);
}

int run(TestOptions& options, const EngineMaker& make_engine) {
  const auto refused = [&](const Problems& problems) {
    return options.console.fail(problems, exit_code_for(problems, Stage::checking));
  };
  if (const Problems wrong = options.running.apply(); !wrong.empty()) return refused(wrong);
  std::vector<std::string> inputs = options.assets.paths();
  if (const Problems wrong = read_twice("", inputs); !wrong.empty()) return refused(wrong);
  inputs.insert(inputs.end(), options.paths.begin(), options.paths.end());
  std::vector<OutputPath> outputs = outputs_of(options);
  if (options.console.json()) outputs.push_back({"--json", "-"});
  if (options.make_folders) {
    if (const Problems wrong = make_folders(outputs); !wrong.empty()) return refused(wrong);
  }
  if (const Problems unfit = unwritable(outputs, inputs); !unfit.empty()) return refused(unfit);
  for (const OutputPath& output : outputs) {
    if (output.path) remove_file(*output.path);
  }
  const TestRun begun = test_run_of_now();
  const auto found = find_graphs(options.paths);
  if (!found) return finish_early(options, begun, found.problems());
  const std::unique_ptr<Engine> engine = make_engine({});
  std::vector<TestGraph> graphs;
  for (const FoundGraph& graph : *found) graphs.push_back(read_test_graph(graph, engine->limits()));
  std::vector<const Json*> documents;
  for (const TestGraph& graph : graphs) {
    if (graph.document) documents.push_back(&*graph.document);
  }
  if (const Problems wrong = options.assets.give_to(*engine, documents, Cancel()); !wrong.empty()) {
    return finish_early(options, begun, wrong);
  }
  std::vector<CaseResult> results = all_results(options, *engine, works_of(graphs));
  add_stale(options, stale_golden(options.golden, graphs, options.paths), results);
  if (options.has_table() && !options.quiet) std::cout << text_of(tally_of(results)) << "\n";
  int code = exit_ok;
  for (const CaseResult& result : results) code = std::max(code, result.code);
  return finish(options, begun, results, code);
}

void add_golden_options(CLI::App& command, GoldenOptions& golden) {
  command.add_option("--golden", golden.folder,
                     "The folder of golden results, which then all cases must have (default: the folder golden beside "
                     "a graph, where there is one)");
  command.add_flag("--update-golden", golden.update, "Write the golden results of what succeeds, instead of comparing");
  command
      .add_option("--tolerance", golden.tolerance,
                  "How far a model may be from its golden result, as a share of its largest extent, beside what files "
                  "round positions by (default: 1e-6)")
      ->check(CLI::Range(0.0, 1.0));
}

}  // namespace

void add_test(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand(
      "test", "Evaluate graphs with all their cases, run their checks, and compare them with golden results");
  command->footer(
      "dini test\n"
      "dini test parts --update-golden --golden golden\n"
      "dini test parts --golden golden --junit junit.xml --sarif dini.sarif --markdown summary.md");
  const auto options = std::make_shared<TestOptions>();
  command->add_option("paths", options->paths, "Graphs, and folders to find graphs in (default: this folder)");
  add_golden_options(*command, options->golden);
  command->add_option("--report", options->report, "Where the results go as JSON, or - for standard output");
  command->add_option("--junit", options->junit, "Where the results go as JUnit XML");
  command->add_option("--sarif", options->sarif, "Where problems and warnings go as SARIF 2.1.0");
  command->add_option("--markdown", options->markdown, "Where the results go as a page for the summary of a job");
  command->add_flag("--mkdir", options->make_folders, "Make the folders of what is written");
  auto* quiet = command->add_flag("--quiet", options->quiet, "Tell what failed only");
  command->add_flag("-v,--verbose", options->verbose, "Tell the time that each node took, on standard error")
      ->excludes(quiet);
  options->console.add_json_option(*command, "Answer with the report instead of the table");
  options->running.add_options(*command, "case", "cases");
  options->assets.add_option(*command);
  options->console.add_options(*command);
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli

#include "cli/testing/run_case.h"

#include "cli/evaluation.h"
#include "cli/exit_codes.h"
#include "service/version.h"

namespace dini::cli {
namespace {

/// One case while it runs.
class Run {
 public:
  Run(const Engine& engine, const TestGraph& graph, const TestCase& asked, const GoldenOptions& golden,
      const RunOptions& running)
      : engine_(engine), graph_(graph), asked_(asked), golden_(golden), running_(running) {
    result_ = {.graph = graph.found.path, .name = asked.name, .source = graph.source};
  }

  CaseResult result() {
    const auto begin = std::chrono::steady_clock::now();
    evaluate();
    if (!asked_.fails.empty()) {
      expect_failure();
    } else if (result_.code == exit_ok) {
      compare_all();
    }
    result_.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return std::move(result_);
  }

 private:
  void evaluate() {
    shared_ = engine_.read(*graph_.document);
    const auto interface = engine_.interface(*shared_);
    if (!interface) return add(failed(interface.problems(), exit_invalid_graph));
    const auto outputs = interface->value("outputs", std::vector<std::string>());
    if (outputs.empty()) return evaluate_checks();
    for (const std::string& output : outputs) evaluate_output(output);
  }

  void add(const Outcome& outcome) {
    result_.code = std::max(result_.code, outcome.code);
    result_.problems.insert(result_.problems.end(), outcome.problems.begin(), outcome.problems.end());
  }

  /// A graph with nothing that could fail must not count as one that did not.
  void evaluate_checks() {
    evaluate_output("");
    if (result_.code != exit_ok || !result_.outputs[""].report.value("checks", Json::array()).empty()) return;
    add(failed({{.code = "unknown-output", .detail = "there is nothing to test: no export node and no check"}},
               exit_invalid_graph));
  }

  /// Without a name, only the checks.
  void evaluate_output(const std::string& output) {
    const Outcome outcome = evaluated(
        engine_,
        {.graph = shared_, .parameters = asked_.parameters, .output = output, .without_output = output.empty()},
        running_.job());
    add(outcome);
    if (outcome.code != exit_ok) return;
    result_.outputs[output].report = outcome.report;
    for (const Json& warning : outcome.report.value("warnings", Json::array())) {
      if (std::find(result_.warnings.begin(), result_.warnings.end(), warning) == result_.warnings.end()) {
        result_.warnings.push_back(warning);
      }
    }
    if (outcome.file != nullptr) files_[output] = outcome.file;
  }

  void expect_failure() {
    const bool is_expected =
        std::ranges::any_of(result_.problems, [&](const Problem& problem) { return problem.code == asked_.fails; });
    if (is_expected) {
      result_.code = exit_ok;
      result_.problems.clear();
    } else if (result_.code == exit_ok) {
      fail_check("unexpected-success", "it was expected to fail with " + asked_.fails + ", and did not");
    }
  }

  void fail_check(std::string code, std::string detail, std::string node = "") {
    result_.code = std::max<int>(result_.code, exit_check_failed);
    result_.problems.push_back({.code = std::move(code), .detail = std::move(detail), .node = std::move(node)});
  }

  void compare_all() {
    if (files_.empty()) return;
    const GoldenFile file = golden_file(golden_, graph_.found.path, graph_.found.root, asked_.name);
    if (!file.is_expected && !golden_.update) return;
    const auto kept = load_golden(file.path);
    if (!kept && !golden_.update) {
      const bool is_io = kept.problems().front().code == "io";
      return add(failed(kept.problems(), is_io ? exit_io : exit_check_failed));
    }
    const GoldenResult* golden = kept && *kept ? &**kept : nullptr;
    if (golden_.update) return update(file.path, golden);
    if (golden == nullptr) {
      for (auto& [output, result] : result_.outputs) result.golden = GoldenState::missing;
      return fail_check("golden-missing",
                        "there is no golden result " + file.path.string() + "; --update-golden writes it");
    }
    for (const auto& [output, made] : files_) compare_output(*golden, output, *made);
    for (const auto& [output, facts] : golden->outputs) {
      if (!files_.contains(output)) fail_check("golden-changed", "the output " + output + " is gone");
    }
  }

  void compare_output(const GoldenResult& golden, const std::string& output, const File& made) {
    OutputResult& result = result_.outputs[output];
    const auto facts = golden.outputs.find(output);
    if (facts == golden.outputs.end()) {
      result.golden = GoldenState::missing;
      return fail_check("golden-missing", "the golden result has no output " + output, output);
    }
    if (facts->second.sha256 == to_hex(made.sha256)) {
      result.golden = GoldenState::same;
      return;
    }
    const std::optional<Model> model = model_of(made);
    if (!model) return fail_check("golden-changed", "the model cannot be read back", output);
    result.comparison = compare(facts->second, *model, golden_.tolerance);
    if (result.comparison.verdict != Comparison::Verdict::changed) {
      result.golden = GoldenState::within;
      return;
    }
    result.golden = GoldenState::changed;
    std::string detail = "the model is not that of the golden result";
    if (golden.graph != to_hex(shared_->hash)) detail += ", which was of another graph";
    if (golden.engine != engine_version) detail += ", which engine " + golden.engine + " made";
    for (const std::string& difference : result.comparison.differences) detail += "; " + difference;
    fail_check("golden-changed", detail, output);
  }

  /// Writes a new golden result unless the one that is kept is of these very files.
  void update(const std::filesystem::path& path, const GoldenResult* golden) {
    GoldenResult fresh{
        .engine = engine_version, .graph = to_hex(shared_->hash), .parameters = asked_.parameters, .outputs = {}};
    bool is_same = golden != nullptr && golden->outputs.size() == files_.size();
    for (const auto& [output, made] : files_) {
      is_same =
          is_same && golden->outputs.contains(output) && golden->outputs.at(output).sha256 == to_hex(made->sha256);
    }
    for (auto& [output, result] : result_.outputs) {
      result.golden = is_same ? GoldenState::same : GoldenState::updated;
    }
    if (is_same) return;
    for (const auto& [output, made] : files_) {
      std::optional<Model> model = model_of(*made);
      if (!model) return fail_check("golden-changed", "the model cannot be read back", output);
      fresh.outputs.emplace(output, std::move(model->facts));
    }
    if (const Problems wrong = save_golden(path, fresh); !wrong.empty()) add(failed(wrong, exit_io));
  }

  const Engine& engine_;
  const TestGraph& graph_;
  const TestCase& asked_;
  const GoldenOptions& golden_;
  const RunOptions& running_;
  SharedGraph shared_;
  std::map<std::string, SharedFile> files_;
  CaseResult result_;
};

}  // namespace

TestGraph read_test_graph(const FoundGraph& found, const Limits& limits) {
  TestGraph graph{.found = found};
  graph.failure.graph = found.path;
  const auto fail_with = [&](const Problems& problems, std::optional<SourceText> source) {
    graph.failure.problems = problems;
    graph.failure.code = exit_code_for(problems, Stage::checking);
    graph.failure.source = std::move(source);
    return graph;
  };
  Result<SourceText> source = read_source(found.path);
  if (!source) return fail_with(source.problems(), std::nullopt);
  graph.source = *std::move(source);
  Result<Json> document = parse_source(*graph.source, limits);
  if (!document) return fail_with(document.problems(), graph.source);
  const std::filesystem::path beside = cases_path(found.path);
  std::error_code error;
  if (!std::filesystem::exists(beside, error)) {
    graph.cases = {TestCase{}};
  } else {
    const Result<SourceText> text = read_source(beside.string());
    if (!text) return fail_with(text.problems(), std::nullopt);
    Result<std::vector<TestCase>> cases = read_cases(text->text, limits);
    if (!cases) return fail_with(cases.problems(), *text);
    graph.cases = *std::move(cases);
  }
  graph.document = *std::move(document);
  return graph;
}

CaseResult run_case(const Engine& engine, const TestGraph& graph, const TestCase& asked, const GoldenOptions& golden,
                    const RunOptions& running) {
  try {
    return Run(engine, graph, asked, golden, running).result();
  } catch (const std::exception& error) {
    return {.graph = graph.found.path,
            .name = asked.name,
            .source = graph.source,
            .code = exit_our_bug,
            .problems = {{.code = "internal", .detail = error.what()}}};
  }
}

}  // namespace dini::cli

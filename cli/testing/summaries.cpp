#include "cli/testing/summaries.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "cli/terminal.h"
#include "service/version.h"

namespace dini::cli {
namespace {

std::string verdict_of(const CaseResult& result) {
  return result.skipped ? "skipped" : result.passed() ? "passed" : "failed";
}

std::string in_milliseconds(double milliseconds) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(milliseconds < 10 ? 1 : 0) << milliseconds << " ms";
  return text.str();
}

std::size_t bytes_of(const CaseResult& result) {
  std::size_t bytes = 0;
  for (const auto& [output, made] : result.outputs) {
    bytes += made.report.value("model", Json::object()).value("bytes", std::size_t{0});
  }
  return bytes;
}

/// How the outputs compare, by name where there are several.
std::string comparison_of(const CaseResult& result) {
  std::string text;
  for (const auto& [output, made] : result.outputs) {
    if (output.empty()) continue;
    std::string state(name_of(made.golden));
    if (made.golden == GoldenState::within) {
      std::ostringstream off;
      off << std::setprecision(2) << made.comparison.deviation;
      state += " (" + off.str() + " m)";
    }
    text += (text.empty() ? "" : ", ") + (result.outputs.size() > 1 ? output + " " + state : state);
  }
  return text;
}

Json output_json(const OutputResult& made) {
  Json json = made.report;
  json["golden"] = name_of(made.golden);
  if (made.golden == GoldenState::within || made.golden == GoldenState::changed) {
    json["deviation"] = std::isfinite(made.comparison.deviation) ? Json(made.comparison.deviation) : Json(nullptr);
    json["accepted_deviation"] = made.comparison.accepted;
    json["differences"] = made.comparison.differences;
  }
  return json;
}

/// Text that ends no cell of a table and is no markup.
std::string markdown_cell(const std::string& text) {
  std::string result;
  for (const char c : printable(text)) {
    if (std::string_view("|<>&*_`[]\\").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

}  // namespace

Json test_report_of(const std::vector<CaseResult>& results) {
  const Tally tally = tally_of(results);
  Json cases = Json::array();
  for (const CaseResult& result : results) {
    Json outputs = Json::object();
    for (const auto& [output, made] : result.outputs) outputs[output.empty() ? "checks" : output] = output_json(made);
    Json json = {{"graph", result.graph},
                 {"verdict", verdict_of(result)},
                 {"milliseconds", result.milliseconds},
                 {"errors", problems_json(result.problems, result.source ? &*result.source : nullptr)},
                 {"outputs", std::move(outputs)}};
    if (!result.name.empty()) json["case"] = result.name;
    cases.push_back(std::move(json));
  }
  return {{"engine", engine_version}, {"succeeded", tally.failed == 0 && tally.skipped == 0 && tally.passed > 0},
          {"passed", tally.passed},   {"failed", tally.failed},
          {"skipped", tally.skipped}, {"cases", std::move(cases)}};
}

std::string test_page_of(const std::vector<CaseResult>& results) {
  const Tally tally = tally_of(results);
  std::string page = "## dini test: " + text_of(tally) + "\n\n| | graph | case | time | bytes | golden result |\n" +
                     "|---|---|---|---:|---:|---|\n";
  std::string details;
  for (const CaseResult& result : results) {
    page += "| " + verdict_of(result) + " | " + markdown_cell(result.graph) + " | " + markdown_cell(result.name) +
            " | " + in_milliseconds(result.milliseconds) + " | " + std::to_string(bytes_of(result)) + " | " +
            markdown_cell(comparison_of(result)) + " |\n";
    for (const Problem& problem : result.problems) {
      details += "- " +
                 markdown_cell((result.name.empty() ? "" : "case " + result.name + ": ") +
                               problem_line(problem, result.source ? &*result.source : nullptr)) +
                 "\n";
    }
  }
  return page + (details.empty() ? "" : "\n### What is wrong\n\n" + details);
}

std::string table_line(const CaseResult& result, std::size_t title_width, bool colored) {
  std::string verdict = verdict_of(result);
  const std::string space(sizeof("skipped") - verdict.size(), ' ');
  if (colored) verdict = (result.passed() ? "\x1b[32m" : "\x1b[1;31m") + verdict + "\x1b[0m";
  std::ostringstream line;
  std::string title = printable(result.title());
  title.resize(std::max(title.size(), title_width), ' ');
  line << verdict << space << title;
  if (!result.skipped) line << "  " << std::setw(8) << in_milliseconds(result.milliseconds);
  if (const std::size_t bytes = bytes_of(result); bytes > 0) line << "  " << std::setw(9) << bytes << " bytes";
  if (const std::string comparison = comparison_of(result); !comparison.empty()) line << "  " << comparison;
  return line.str();
}

}  // namespace dini::cli

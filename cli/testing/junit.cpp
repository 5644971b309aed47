#include "cli/testing/junit.h"

#include <array>
#include <chrono>
#include <iomanip>
#include <set>
#include <sstream>
#include <unistd.h>

#include "cli/exit_codes.h"
#include "cli/terminal.h"
#include "geometry/markup.h"
#include "server/text.h"
#include "service/version.h"

namespace dini::cli {
namespace {

/// Text that may stand in XML: without control characters, in UTF-8.
std::string escaped(const std::string& text) {
  return escaped_markup(Json::parse(dump(Json(printable(text)))).get<std::string>());
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + escaped(value) + "\"";
}

std::string seconds(double milliseconds) {
  constexpr double per_second = 1000;
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << milliseconds / per_second;
  return text.str();
}

struct Counts {
  std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
  double milliseconds = 0;

  void add(const CaseResult& result) {
    ++tests;
    if (result.skipped) {
      ++skipped;
    } else if (!result.passed()) {
      ++(result.code == exit_check_failed ? failures : errors);
    }
    milliseconds += result.milliseconds;
  }

  /// Those of `testsuites`; a suite has `skipped` besides, which the schema of Jenkins takes only there.
  std::string attributes() const {
    return attribute("tests", std::to_string(tests)) + attribute("failures", std::to_string(failures)) +
           attribute("errors", std::to_string(errors)) + attribute("time", seconds(milliseconds));
  }
};

std::string case_element(const CaseResult& result) {
  std::string text = "    <testcase" + attribute("name", result.name.empty() ? "default" : result.name) +
                     attribute("classname", result.graph) + attribute("time", seconds(result.milliseconds));
  if (result.skipped) {
    return text + ">\n      <skipped" + attribute("type", "skipped") +
           attribute("message", "not begun after another case failed") + "/>\n    </testcase>\n";
  }
  if (result.passed()) return text + "/>\n";
  const Problem& first = result.problems.front();
  const std::string element = result.code == exit_check_failed ? "failure" : "error";
  text += ">\n      <" + element + attribute("type", first.code) + attribute("message", first.detail) + ">";
  const SourceText* source = result.source ? &*result.source : nullptr;
  for (std::size_t i = 0; i < result.problems.size(); ++i) {
    text += (i > 0 ? "\n" : "") + escaped(problem_line(result.problems[i], source));
  }
  return text + "</" + element + ">\n    </testcase>\n";
}

/// The warnings of all cases, each once.
std::string warnings_in(const CaseResult& result, std::set<std::string>& told) {
  std::string text;
  if (!result.source) return text;
  for (const std::string& line : warning_lines({{"warnings", result.warnings}}, *result.source)) {
    if (told.insert(line).second) text += line + "\n";
  }
  return text;
}

/// A suite with everything that any of the common schemas demands of it, in the order that they demand.
std::string suite_element(const std::string& graph, std::size_t id, const Counts& counts, const TestRun& run,
                          const std::string& cases, const std::string& warnings) {
  return "  <testsuite" + attribute("name", graph) + attribute("package", graph) + attribute("id", std::to_string(id)) +
         attribute("timestamp", run.begun) + attribute("hostname", run.host) + counts.attributes() +
         attribute("skipped", std::to_string(counts.skipped)) + ">\n    <properties>\n      <property" +
         attribute("name", "engine") + attribute("value", engine_version) + "/>\n    </properties>\n" + cases +
         "    <system-out/>\n    <system-err>" + escaped_markup(warnings) + "</system-err>\n  </testsuite>\n";
}

}  // namespace

TestRun test_run_of_now() {
  const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
  const std::string begun =
      server::time_text(std::chrono::duration_cast<std::chrono::milliseconds>(since_epoch).count());
  constexpr std::size_t to_seconds = std::string_view("2026-01-31T12:00:00").size();
  std::array<char, 256> host{};
  const bool is_known = ::gethostname(host.data(), host.size() - 1) == 0 && host.front() != '\0';
  return {begun.substr(0, to_seconds), is_known ? host.data() : "localhost"};
}

std::string junit_of(const std::vector<CaseResult>& results, const TestRun& run) {
  Counts all;
  std::string suites;
  std::size_t id = 0;
  for (std::size_t begin = 0, end = 0; begin < results.size(); begin = end) {
    Counts counts;
    std::string cases, warnings;
    std::set<std::string> told;
    for (end = begin; end < results.size() && results[end].graph == results[begin].graph; ++end) {
      counts.add(results[end]);
      all.add(results[end]);
      cases += case_element(results[end]);
      warnings += warnings_in(results[end], told);
    }
    suites += suite_element(results[begin].graph, id++, counts, run, cases, warnings);
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + attribute("name", "dini") + all.attributes() +
         ">\n" + suites + "</testsuites>\n";
}

}  // namespace dini::cli

#include "cli/testing/junit.h"

#include <iomanip>
#include <sstream>

#include "cli/exit_codes.h"
#include "cli/terminal.h"
#include "geometry/markup.h"

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

  std::string attributes() const {
    return attribute("tests", std::to_string(tests)) + attribute("failures", std::to_string(failures)) +
           attribute("errors", std::to_string(errors)) + attribute("time", seconds(milliseconds));
  }
};

std::string case_element(const CaseResult& result) {
  std::string text = "    <testcase" + attribute("name", result.name.empty() ? "default" : result.name) +
                     attribute("classname", result.graph) + attribute("time", seconds(result.milliseconds));
  if (result.skipped) return text + ">\n      <skipped/>\n    </testcase>\n";
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

}  // namespace

std::string junit_of(const std::vector<CaseResult>& results) {
  Counts all;
  std::string suites;
  for (std::size_t begin = 0, end = 0; begin < results.size(); begin = end) {
    Counts counts;
    std::string cases;
    for (end = begin; end < results.size() && results[end].graph == results[begin].graph; ++end) {
      counts.add(results[end]);
      all.add(results[end]);
      cases += case_element(results[end]);
    }
    suites += "  <testsuite" + attribute("name", results[begin].graph) + counts.attributes() +
              attribute("skipped", std::to_string(counts.skipped)) + ">\n" + cases + "  </testsuite>\n";
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + attribute("name", "dini") + all.attributes() +
         ">\n" + suites + "</testsuites>\n";
}

}  // namespace dini::cli

#include "cli/testing/sarif.h"

#include <cctype>
#include <filesystem>

#include "service/problem_codes.h"
#include "service/version.h"

namespace dini::cli {
namespace {

/// A path as the reference of a URI (RFC 3986).
std::string uri_of(const std::string& path) {
  constexpr std::string_view hexadecimal = "0123456789ABCDEF";
  std::string uri;
  for (const char c : std::filesystem::path(path).lexically_normal().string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || std::string_view("-._~/").find(c) != std::string_view::npos) {
      uri += c;
    } else {
      uri += '%';
      uri += hexadecimal[byte >> 4];
      uri += hexadecimal[byte & 15];
    }
  }
  return uri;
}

class Log {
 public:
  void add(const CaseResult& result, const Problem& problem, const char* level) {
    std::string text =
        problem.node.empty() ? "" : problem.node + (problem.port.empty() ? "" : "." + problem.port) + ": ";
    if (!result.name.empty()) text = "case " + result.name + ": " + text;
    const std::string file = result.source && result.source->name != result.graph ? result.source->name : result.graph;
    Json physical = {{"artifactLocation", {{"uri", uri_of(file)}}}};
    const auto place = result.source ? place_of(*result.source, problem) : std::nullopt;
    physical["region"] = {{"startLine", place ? place->line : 1}, {"startColumn", place ? place->column : 1}};
    const std::size_t rule = rule_of(problem.code);
    results_.push_back({{"ruleId", problem.code},
                        {"ruleIndex", rule},
                        {"level", level},
                        {"message", {{"text", text + problem.detail}}},
                        {"locations", Json::array({{{"physicalLocation", std::move(physical)}}})}});
  }

  Json finished() && {
    const Json driver = {{"name", "dini"}, {"version", engine_version}, {"rules", std::move(rules_)}};
    const Json run = {
        {"tool", {{"driver", driver}}}, {"columnKind", "unicodeCodePoints"}, {"results", std::move(results_)}};
    return {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
            {"version", "2.1.0"},
            {"runs", Json::array({run})}};
  }

 private:
  std::size_t rule_of(const std::string& code) {
    for (std::size_t i = 0; i < rules_.size(); ++i) {
      if (rules_[i]["id"] == code) return i;
    }
    Json rule = {{"id", code}};
    if (const ProblemCode* known = find_problem_code(code)) rule["shortDescription"] = {{"text", known->meaning}};
    rules_.push_back(std::move(rule));
    return rules_.size() - 1;
  }

  Json rules_ = Json::array();
  Json results_ = Json::array();
};

}  // namespace

Json sarif_of(const std::vector<CaseResult>& results) {
  Log log;
  for (const CaseResult& result : results) {
    for (const Problem& problem : result.problems) log.add(result, problem, "error");
    for (const Json& warning : result.warnings) {
      log.add(result,
              {.code = warning.value("code", ""),
               .detail = warning.value("detail", ""),
               .node = warning.value("node", ""),
               .port = warning.value("port", "")},
              "warning");
    }
  }
  return std::move(log).finished();
}

}  // namespace dini::cli

#include "cli/testing/cases.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "graph/nearest.h"
#include "service/problem_codes.h"

namespace dini::cli {
namespace {

Problem refused(std::string pointer, std::string detail) {
  return {.code = "bad-cases", .detail = std::move(detail), .pointer = std::move(pointer)};
}

/// Members beside the known ones.
Problems unknown_members(const Json& object, const std::string& pointer, const std::vector<std::string>& known) {
  Problems problems;
  for (const auto& [name, value] : object.items()) {
    if (std::ranges::find(known, name) != known.end()) continue;
    std::string list;
    for (const std::string& each : known) list += (list.empty() ? "" : ", ") + each;
    problems.push_back(refused(pointer + "/" + pointer_token(name),
                               "unknown member \"" + name + "\"" + did_you_mean(name, known) + "; there is " + list));
  }
  return problems;
}

bool is_name(const std::string& name) {
  return !name.empty() && name.front() != '.' && name.size() <= 64 && std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == ' ' || c == '_' || c == '-' || c == '.';
  });
}

Problems faults_in(const std::string& name, const Json& given, const std::string& pointer) {
  if (!is_name(name)) {
    return {refused(pointer, "names of cases are 1 to 64 letters, digits, space, _, - and ., not \"" + name + "\"")};
  }
  if (!given.is_object()) return {refused(pointer, "a case is an object")};
  Problems problems = unknown_members(given, pointer, {"parameters", "fails", "description"});
  if (given.contains("parameters") && !given["parameters"].is_object()) {
    problems.push_back(refused(pointer + "/parameters", "parameters are an object of values by name"));
  }
  for (const char* member : {"fails", "description"}) {
    if (given.contains(member) && !given[member].is_string()) {
      problems.push_back(refused(pointer + "/" + member, std::string(member) + " is a text"));
    }
  }
  if (!problems.empty() || !given.contains("fails")) return problems;
  const std::string code = given["fails"].get<std::string>();
  if (find_problem_code(code) != nullptr) return {};
  std::vector<std::string> known;
  for (const ProblemCode& each : problem_codes()) known.emplace_back(each.code);
  return {refused(pointer + "/fails", "there is no problem \"" + code + "\"" + did_you_mean(code, known))};
}

}  // namespace

Result<std::vector<TestCase>> read_cases(const std::string& text, const Limits& limits) {
  const Result<Json> json = parse_json(text, limits);
  if (!json) return json.problems();
  if (!json->is_object() || !json->contains("cases") || !json->at("cases").is_object()) {
    return refused("", "a file of cases is an object with the member cases, an object of cases by name");
  }
  Problems problems = unknown_members(*json, "", {"cases", "$schema"});
  std::vector<TestCase> cases;
  for (const auto& [name, given] : json->at("cases").items()) {
    const std::string pointer = "/cases/" + pointer_token(name);
    Problems faults = faults_in(name, given, pointer);
    problems.insert(problems.end(), faults.begin(), faults.end());
    if (faults.empty()) cases.push_back({name, given.value("parameters", Json::object()), given.value("fails", "")});
  }
  if (problems.empty() && cases.empty()) problems.push_back(refused("/cases", "there is no case"));
  if (!problems.empty()) return problems;
  return cases;
}

}  // namespace dini::cli

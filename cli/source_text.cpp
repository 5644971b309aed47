#include "cli/source_text.h"

#include "cli/documents.h"

namespace dini::cli {
namespace {

/// Far more than any graph within the limits has.
constexpr std::size_t most_source_bytes = std::size_t{64} << 20;

}  // namespace

Result<SourceText> read_source(const std::string& path) {
  Result<std::string> text = read_input(path, most_source_bytes);
  if (!text) return text.problems();
  SourceText source{path == "-" ? "standard input" : path, *std::move(text)};
  if (source.text.starts_with("\xFF\xFE") || source.text.starts_with("\xFE\xFF")) {
    return Problem{.code = "not-json",
                   .detail = source.name + ": the text is UTF-16, and documents are read in UTF-8 only"};
  }
  return source;
}

Result<Json> parse_source(const SourceText& source, const Limits& limits) { return parse_json(source.text, limits); }

std::optional<TextPlace> place_of(const SourceText& source, const Problem& problem) {
  if (problem.in_request) return std::nullopt;
  if (problem.code == "not-json") {
    const auto offset = offset_of_fault(source.text, Limits());
    if (!offset) return std::nullopt;
    return place_at(source.text, *offset);
  }
  std::string pointer = problem.pointer.value_or("");
  if (pointer.empty() && !problem.node.empty()) {
    pointer = "/nodes/" + pointer_token(problem.node);
    if (!problem.port.empty()) pointer += "/inputs/" + pointer_token(problem.port);
  }
  if (pointer.empty()) return std::nullopt;
  return place_at(source.text, offset_of(read_json_text(source.text), pointer));
}

Json problems_json(const Problems& problems, const SourceText* source) {
  Json list = to_json(problems, Sent::document);
  for (std::size_t i = 0; source != nullptr && i < problems.size(); ++i) {
    if (problems[i].in_request) continue;
    list[i]["file"] = source->name;
    const auto place = place_of(*source, problems[i]);
    if (!place) continue;
    list[i]["line"] = place->line;
    list[i]["column"] = place->column;
  }
  return list;
}

Problems problems_of_request(const Json& errors) {
  constexpr std::string_view graph = "/graph";
  Problems problems;
  for (const Json& error : errors) {
    Problem problem{.code = error.value("code", ""),
                    .detail = error.value("detail", ""),
                    .node = error.value("node", ""),
                    .port = error.value("port", "")};
    const std::string pointer = error.value("pointer", std::string(graph));
    problem.in_request = !pointer.starts_with(graph);
    if (error.contains("pointer")) problem.pointer = problem.in_request ? pointer : pointer.substr(graph.size());
    if (!problem.in_request && error.contains("fix")) {
      problem.fix = error["fix"];
      for (Json& step : problem.fix) {
        for (const char* member : {"path", "from"}) {
          if (step.contains(member)) step[member] = step[member].get<std::string>().substr(graph.size());
        }
      }
    }
    problems.push_back(std::move(problem));
  }
  return problems;
}

}  // namespace dini::cli

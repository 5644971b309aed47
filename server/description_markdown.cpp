#include "server/description_markdown.h"

#include <optional>

#include "server/description_tables.h"

namespace dini::server {
namespace {

constexpr std::string_view begin_mark = "<!-- generated: ";
constexpr std::string_view end_of_mark = " -->\n";
constexpr std::string_view end_mark = "<!-- end -->";

/// Inside a cell a bar would end it.
std::string row_of(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) {
    row += " ";
    for (const char c : cell) row += c == '|' ? std::string("\\|") : std::string(1, c);
    row += " |";
  }
  return row + "\n";
}

std::string markdown(const Table& table) {
  std::string text = row_of(table.headings) + "|";
  for (std::size_t i = 0; i < table.headings.size(); ++i) text += "---|";
  text += "\n";
  for (const auto& row : table.rows) text += row_of(row);
  return text;
}

std::string all_codes() {
  std::string text;
  for (const ProblemKind kind : problem_kinds()) {
    text +=
        (text.empty() ? "Codes " : "\nCodes ") + std::string(title_of(kind)) + ":\n\n" + markdown(codes_table(kind));
  }
  return text;
}

std::optional<Operation> find_operation(std::string_view id) {
  for (const Route& route : routes()) {
    Operation operation = route.describe();
    if (operation.id == id) return operation;
  }
  return std::nullopt;
}

/// The text of a part; nothing for a name that is none.
std::optional<std::string> part(std::string_view name) {
  if (name == "routes") return markdown(routes_table(routes()));
  if (name == "limits") return markdown(limits_table());
  if (name == "statuses") return markdown(statuses_table());
  if (name == "headers") return markdown(headers_table());
  if (name == "codes") return all_codes();
  const auto space = name.find(' ');
  if (space == std::string_view::npos) return std::nullopt;
  const auto operation = find_operation(name.substr(space + 1));
  const std::string_view what = name.substr(0, space);
  if (!operation) return std::nullopt;
  if (what == "members" && operation->request != nullptr) return markdown(members_table(*operation->request));
  if (what == "parameters") return markdown(parameters_table(*operation));
  if (what == "answers") return markdown(answers_table(*operation));
  return std::nullopt;
}

}  // namespace

Result<std::string> with_generated_parts(std::string_view page) {
  std::string result;
  for (auto mark = page.find(begin_mark); mark != std::string_view::npos; mark = page.find(begin_mark)) {
    const auto name_begin = mark + begin_mark.size();
    const auto name_end = page.find(end_of_mark, name_begin);
    const auto end = page.find(end_mark, name_begin);
    if (name_end == std::string_view::npos || end == std::string_view::npos || end < name_end) {
      return Problem{.code = "usage", .detail = "a generated part has no end"};
    }
    const std::string_view name = page.substr(name_begin, name_end - name_begin);
    const auto text = part(name);
    if (!text) return Problem{.code = "usage", .detail = "there is no generated part '" + std::string(name) + "'"};
    result.append(page.substr(0, name_end + end_of_mark.size())).append("\n").append(*text).append("\n");
    page.remove_prefix(end);
  }
  return result.append(page);
}

}  // namespace dini::server

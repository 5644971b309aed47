#include "cli/sweeping/table.h"

#include "cli/exit_codes.h"

namespace dini::cli {
namespace {

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string csv_cell(const Json& value) {
  if (value.is_null()) return "";
  return csv_cell(value.is_string() ? value.get<std::string>() : dump(value));
}

std::string line(const std::vector<std::string>& cells) {
  std::string text = cells.front();
  for (std::size_t i = 1; i < cells.size(); ++i) text += "," + cells[i];
  return text + "\r\n";
}

}  // namespace

std::string table_of(const std::vector<SweptVariant>& variants, const std::vector<std::string>& measures,
                     bool tells_outputs) {
  static const std::vector<std::string> of_model = {"bytes", "vertices", "triangles", "sha256"};
  std::vector<std::string> head = {"index"};
  const Json names = variants.empty() ? Json::object() : variants.front().setting;
  for (const auto& [name, value] : names.items()) head.push_back(csv_cell(name));
  if (tells_outputs) head.emplace_back("output");
  head.insert(head.end(), {"file", "result"});
  head.insert(head.end(), of_model.begin(), of_model.end());
  for (const std::string& measure : measures) head.push_back(csv_cell(measure));
  std::string table = line(head);
  for (const SweptVariant& variant : variants) {
    const Outcome& outcome = variant.outcome;
    std::vector<std::string> cells = {std::to_string(variant.index)};
    for (const auto& [name, value] : variant.setting.items()) cells.push_back(csv_cell(value));
    if (tells_outputs) cells.push_back(csv_cell(variant.output));
    cells.push_back(csv_cell(variant.file));
    cells.push_back(outcome.code == exit_ok ? "ok" : csv_cell(outcome.problems.front().code));
    const Json model = outcome.report.value("model", Json::object());
    for (const std::string& name : of_model) cells.push_back(csv_cell(model.value(name, Json())));
    const Json measured = outcome.report.value("measures", Json::object());
    for (const std::string& measure : measures) cells.push_back(csv_cell(measured.value(measure, Json())));
    table += line(cells);
  }
  return table;
}

}  // namespace dini::cli

#include "server/html.h"

#include <algorithm>

#include "geometry/markup.h"

namespace dini::server::html {

std::string prose(std::string_view text) {
  std::string result;
  bool in_code = false;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t tick = std::min(text.find('`', at), text.size());
    const std::string piece = escaped_markup(text.substr(at, tick - at));
    result += in_code ? element("code", piece) : piece;
    in_code = !in_code;
    at = tick + 1;
  }
  return result;
}

std::string element(std::string_view name, std::string_view content, std::string_view attributes) {
  std::string text = "<" + std::string(name);
  if (!attributes.empty()) text.append(" ").append(attributes);
  return text.append(">").append(content).append("</").append(name).append(">");
}

std::string table(const Table& table) {
  if (table.rows.empty()) return "";
  const auto is_empty = [&](std::size_t column) {
    return std::ranges::all_of(table.rows, [&](const auto& row) { return row[column].empty(); });
  };
  std::string head, body;
  for (std::size_t column = 0; column < table.headings.size(); ++column) {
    if (!is_empty(column)) head += element("th", escaped_markup(table.headings[column]));
  }
  for (const auto& row : table.rows) {
    std::string cells;
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (is_empty(column)) continue;
      std::string cell = prose(row[column]);
      if (column == 0 && !table.link_folder.empty()) {
        std::string name = row[column];
        std::erase(name, '`');
        cell = element("a", cell, "href=\"" + escaped_markup(table.link_folder + "/" + name) + "\"");
      }
      cells += element("td", cell);
    }
    body += element("tr", cells) + "\n";
  }
  return element("div", element("table", element("thead", element("tr", head)) + "\n" + element("tbody", body)),
                 "class=\"table\" tabindex=\"0\"") +
         "\n";
}

std::string page(std::string_view title, std::string_view style, std::string_view body) {
  return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
         element("title", escaped_markup(title)) + "\n<link rel=\"stylesheet\" href=\"" + escaped_markup(style) +
         "\">\n</head>\n<body>\n" + std::string(body) + "</body>\n</html>\n";
}

}  // namespace dini::server::html

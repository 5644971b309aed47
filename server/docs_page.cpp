#include "server/docs_page.h"

#include <algorithm>

#include "geometry/markup.h"
#include "server/html.h"
#include "server/responses.h"
#include "server/text.h"
#include "service/requests/results.h"

namespace dini::server {
namespace {

using html::element;

std::string id_of(std::string_view text) { return "id=\"" + escaped_markup(text) + "\""; }

std::string method_mark(std::string_view method) {
  return element("span", escaped_markup(method), "class=\"method " + to_lower(method) + "\"");
}

/// A heading and a table below it; nothing without rows.
std::string titled(std::string_view title, const Table& table) {
  return table.rows.empty() ? "" : element("h4", escaped_markup(title)) + "\n" + html::table(table);
}

std::string folded(std::string_view title, std::string_view content) {
  return element("details", element("summary", escaped_markup(title)) + std::string(content)) + "\n";
}

std::string json_block(const Json& json) { return element("pre", element("code", escaped_markup(json.dump(2)))); }

std::string operation_html(const Route& route, const Operation& operation) {
  std::string text = element("h3", method_mark(route.method) + " " + element("code", escaped_markup(route.path)));
  text += element("p", element("strong", html::prose(operation.title + ".")) + " " + html::prose(operation.doc));
  text += titled("Parameters", parameters_table(operation));
  if (operation.request != nullptr) {
    text += titled("Members of the body", members_table(*operation.request));
    text += folded("An example", json_block(example_of(*operation.request)));
  }
  if (operation.takes_document) text += folded("An example", json_block(example_graph()));
  if (!operation.file_types.empty()) {
    std::string types;
    for (const std::string& type : operation.file_types) types += (types.empty() ? "" : ", ") + element("code", type);
    text += element("p", "The body is the file itself, as one of " + types + ".");
  }
  text += titled("Answers", answers_table(operation));
  for (const Answer& answer : operation.answers) {
    for (const Content& content : answer.contents) {
      if (content.schema.is_null()) continue;
      const Table members = schema_table(content.schema);
      if (!members.rows.empty()) text += folded("Members of the answer", html::table(members));
    }
  }
  text += folded("Problems", html::table(operation_problems_table(route, operation)));
  return element("section", text, id_of(operation.id)) + "\n";
}

/// What is about one thing stands together, in the order in which the first of each comes.
std::vector<std::string> groups_of(std::span<const Route> routes) {
  std::vector<std::string> groups;
  for (const auto* wanted : {"Graphs", "Files", "Catalogue", "Service"}) groups.emplace_back(wanted);
  for (const Route& route : routes) {
    const std::string group = route.describe().group;
    if (std::ranges::find(groups, group) == groups.end()) groups.push_back(group);
  }
  return groups;
}

std::string link(std::string_view to, std::string_view text) {
  return element("a", text, "href=\"" + escaped_markup(to) + "\"");
}

}  // namespace

std::string docs_html(std::span<const Route> routes, const std::string& version) {
  std::string contents, sections;
  for (const std::string& group : groups_of(routes)) {
    std::string entries;
    sections += element("h2", escaped_markup(group), id_of(to_lower(group))) + "\n";
    for (const Route& route : routes) {
      const Operation operation = route.describe();
      if (operation.group != group) continue;
      entries += element("li", link("#" + operation.id,
                                    method_mark(route.method) + " " + element("code", escaped_markup(route.path))));
      sections += operation_html(route, operation);
    }
    contents += element("h2", escaped_markup(group)) + element("ul", entries) + "\n";
  }
  std::string shapes;
  const Json components = result_schemas();
  for (const auto& [name, schema] : components.items()) {
    shapes += element("h3", element("code", escaped_markup(name)), id_of(name)) + "\n" +
              element("p", html::prose(schema.value("description", ""))) + html::table(schema_table(schema));
  }
  std::string codes;
  for (const ProblemKind kind : problem_kinds()) {
    codes +=
        element("h3", escaped_markup("Codes " + std::string(title_of(kind)))) + "\n" + html::table(codes_table(kind));
  }
  contents += element("h2", "Everywhere") +
              element("ul", element("li", link("#headers", "Headers of answers")) +
                                element("li", link("#shapes", "Parts of answers")) +
                                element("li", link("#limits", "Limits")) + element("li", link("#codes", "Problems")));
  const std::string head =
      element("h1", "Dini " + escaped_markup(version)) +
      element("p",
              "Graphs of geometry nodes, evaluated into Draco-compressed glTF. This page is made of the same "
              "declarations as " +
                  link("openapi.json", element("code", "openapi.json")) + ". A " + element("code", "GET") +
                  " address answers " + element("code", "HEAD") + " too.");
  return html::page(
      "Dini: HTTP interface", "docs/style.css",
      element("nav", element("p", link("./", "Dini"), "class=\"home\"") + contents, "aria-label=\"Contents\"") +
          element("main", head + sections + element("h2", "Headers of answers", id_of("headers")) +
                              html::table(headers_table()) + element("h2", "Parts of answers", id_of("shapes")) +
                              shapes + element("h2", "Limits", id_of("limits")) + html::table(limits_table()) +
                              element("h2", "Problems", id_of("codes")) +
                              element("p", html::prose("Every error is an `application/problem+json` (RFC 9457) whose "
                                                       "`errors` have these codes.")) +
                              codes));
}

std::string problem_page_html(const ProblemCode& code) {
  std::string body = element("p", link("../docs#codes", "All problems"), "class=\"home\"") +
                     element("h1", element("code", escaped_markup(code.code))) +
                     element("p", html::prose(code.meaning));
  if (code.status != 0) {
    body += element("p", "HTTP status " + element("code", std::to_string(code.status)) + ": " +
                             escaped_markup(title_of_code(code.code)) + ".");
  } else {
    body += element("p", code.kind == ProblemKind::warning ? "A warning: the answer that it stands in is good."
                                                           : "Told by the program <code>dini</code> only.");
  }
  return html::page("Dini: " + std::string(code.code), "../docs/style.css", element("main", body));
}

}  // namespace dini::server

#include "server/docs_page.h"
#include "server/handlers.h"
#include "server/negotiation.h"
#include "server/responses.h"
#include "server/server_limits.h"
#include "server/text.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

/// What is kept in memory and answered with a tag: the same for all routes that do so.
Operation describe_static(std::string id, std::string group, std::string title, std::string doc, Content content) {
  const std::string told = doc;
  return {.id = std::move(id),
          .group = std::move(group),
          .title = std::move(title),
          .doc = std::move(doc),
          .parameters = {if_none_match_header()},
          .answers = {{.doc = told, .contents = {std::move(content)}, .headers = {"ETag", "Cache-Control"}},
                      not_modified()}};
}

Parameter in_path(std::string name, std::string doc, std::string example) {
  return {
      .place = Parameter::Place::path, .name = std::move(name), .doc = std::move(doc), .example = std::move(example)};
}

template <class Owner>
void add_limits(std::span<const Limit<Owner>> limits, std::vector<schema::Property>& properties) {
  for (const Limit<Owner>& limit : limits) {
    Json number = schema::whole(std::string(limit.unit) + " " + std::string(limit.doc));
    number["examples"] = Json::array({limit.get(Owner{})});
    properties.push_back({std::string(limit.name), std::move(number)});
  }
}

}  // namespace

Operation describe_health() {
  return {.id = "health",
          .group = "Service",
          .title = "Whether the server takes requests",
          .doc = "Answers while the server takes requests.",
          .answers = {{.doc = "It does.",
                       .contents = {{.type = "application/json",
                                     .schema = schema::object({{"status", schema::word({"ok"}, "Always `ok`.")}}),
                                     .example = {{"status", "ok"}}}}}},
          .takes_any_query = true};
}

Operation describe_version() {
  std::vector<schema::Property> limits;
  add_limits(evaluation_limits(), limits);
  add_limits(server_limits(), limits);
  return {.id = "version",
          .group = "Service",
          .title = "The version of the engine, and every limit by name",
          .doc = "The version of the engine, and every limit by name.",
          .answers = {{.doc = "What runs here.",
                       .contents = {{.type = "application/json",
                                     .schema = schema::object({{"engine", schema::text("The version of the engine.")},
                                                               {"limits", schema::object(limits, "By name.")}})}}}}};
}

Operation describe_nodes() {
  return describe_static("nodes", "Catalogue", "The catalogue: wire types, families, node types",
                         "Wire types, families, and a card for every node type.",
                         {.type = "application/json", .schema = schema::reference("Catalogue")});
}

Operation describe_schema() {
  return describe_static("documentSchema", "Catalogue", "The form of the graph document",
                         "The JSON Schema (2020-12) of the graph document, with every node type.",
                         {.type = "application/schema+json", .schema = schema::anything("A JSON Schema.")});
}

Operation describe_example_list() {
  const Json entry = schema::object({{"id", schema::text("Names the example.")},
                                     {"title", schema::text("As people read it.")},
                                     {"description", schema::text("What it shows."), true},
                                     {"figure", schema::text("The figure of the paper that it is."), true},
                                     {"image", schema::text("The address of its picture."), true},
                                     {"graph", schema::reference("Graph")}});
  return describe_static("examples", "Catalogue", "The built-in graphs", "The built-in graphs, with their documents.",
                         {.type = "application/json",
                          .schema = schema::object({{"examples", schema::list(entry, "In the order of their ids.")}})});
}

Operation describe_example() {
  Operation operation =
      describe_static("example", "Catalogue", "One built-in graph", "The document of a built-in graph.",
                      {.type = "application/json", .schema = schema::reference("Graph")});
  operation.parameters.push_back(in_path("id", "The id of the example.", "fig04_boosted_ring"));
  operation.problems = {"not-found"};
  return operation;
}

Operation describe_example_picture() {
  Operation operation = describe_static("examplePicture", "Catalogue", "The picture of an example",
                                        "A picture of the model of an example.", {.type = "image/png"});
  operation.parameters.push_back(in_path("name", "`<id>.png`, as `image` in the list says.", "fig04_boosted_ring.png"));
  operation.problems = {"not-found"};
  return operation;
}

Operation describe_openapi() {
  return describe_static("openapi", "Service", "This interface, for programs",
                         "The description of all routes, as OpenAPI 3.1.",
                         {.type = "application/json", .schema = schema::anything("An OpenAPI document.")});
}

Reply openapi(const Context& context) {
  return static_reply(context.request(), context.application.openapi, "application/json");
}

Operation describe_docs() {
  return describe_static("docs", "Service", "This interface, to read",
                         "The same description as `/openapi.json`, as a page.", {.type = "text/html"});
}

Reply docs(const Context& context) {
  return static_reply(context.request(), context.application.docs, "text/html; charset=utf-8");
}

Operation describe_docs_style() {
  return describe_static("docsStyle", "Service", "The style sheet of `/docs`", "The style sheet of `/docs`.",
                         {.type = "text/css"});
}

Reply docs_style(const Context& context) {
  return static_reply(context.request(), context.application.docs_style, "text/css; charset=utf-8");
}

Operation describe_problem_page() {
  Operation operation = describe_static("problemPage", "Service", "What a code of problems means",
                                        "A page about a code of problems: the `type` of every problem leads here.",
                                        {.type = "text/html"});
  operation.parameters.push_back(in_path("code", "The code.", "out-of-range"));
  operation.problems = {"not-found"};
  return operation;
}

Reply problem_page(const Context& context) {
  const ProblemCode* code = find_problem_code(context.arguments.front());
  if (code == nullptr) {
    return problem_reply(Problem{.code = "not-found", .detail = "There is no such code; /docs lists them."},
                         context.exchange());
  }
  return static_reply(context.request(), static_answer(problem_page_html(*code)), "text/html; charset=utf-8");
}

Reply health(const Context&) { return json_reply({{"status", "ok"}}); }

Reply version(const Context& context) {
  Json limits = Json::object();
  for (const Limit<Limits>& limit : evaluation_limits()) {
    limits[std::string(limit.name)] = limit.get(context.engine().limits());
  }
  for (const Limit<Settings>& limit : server_limits()) {
    limits[std::string(limit.name)] = limit.get(context.application.settings);
  }
  return json_reply({{"engine", context.engine().catalogue().value("engine", "")}, {"limits", std::move(limits)}});
}

Reply nodes(const Context& context) {
  return static_reply(context.request(), context.application.catalogue, "application/json");
}

Reply schema(const Context& context) {
  return static_reply(context.request(), context.application.document_schema, "application/schema+json");
}

Reply example_list(const Context& context) {
  return static_reply(context.request(), context.application.example_list, "application/json");
}

Reply example(const Context& context) {
  const auto* graph = context.application.examples.find(context.arguments.front());
  if (graph == nullptr) {
    return problem_reply(
        Problem{.code = "not-found", .detail = "There is no example of that name; GET /v1/examples lists them."},
        context.exchange());
  }
  return static_reply(context.request(), static_answer(graph->dump()), "application/json");
}

Reply example_picture(const Context& context) {
  const StaticAnswer* picture = context.application.examples.picture(context.arguments.front());
  return picture == nullptr ? page_file(context) : static_reply(context.request(), *picture, "image/png");
}

Result<Json> read_json(const Context& context) {
  const std::string_view type = context.request().header("Content-Type");
  if (!equal_ignoring_case(trim(type.substr(0, type.find(';'))), "application/json")) {
    return Problem{.code = "unsupported-media-type", .detail = "Send the body as application/json."};
  }
  return parse_json(context.request().body, context.engine().limits());
}

}  // namespace dini::server

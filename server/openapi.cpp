#include "server/openapi.h"

#include <map>

#include "server/access.h"
#include "server/responses.h"
#include "server/text.h"
#include "service/requests/results.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

constexpr std::string_view problem_type = "application/problem+json";

Json parameter_json(const Parameter& parameter) {
  Json json = {{"name", parameter.name},
               {"in", name_of(parameter.place)},
               {"description", parameter.doc},
               {"schema", parameter.schema}};
  if (parameter.place == Parameter::Place::path) json["required"] = true;
  if (!parameter.example.is_null()) json["example"] = parameter.example;
  return json;
}

Json content_json(const Content& content) {
  Json json = Json::object();
  if (!content.schema.is_null()) json["schema"] = content.schema;
  if (!content.example.is_null()) json["example"] = content.example;
  return json;
}

Json header_references(const std::vector<std::string>& names) {
  Json headers = Json::object();
  for (const std::string& name : names) headers[name] = {{"$ref", "#/components/headers/" + name}};
  for (const auto* name : {"Server-Timing", "X-Request-Id"}) {
    headers[name] = {{"$ref", "#/components/headers/" + std::string(name)}};
  }
  return headers;
}

Json answer_json(const Answer& answer, bool head) {
  Json json = {{"description", answer.doc}, {"headers", header_references(answer.headers)}};
  if (head) return json;
  for (const Content& content : answer.contents) json["content"][content.type] = content_json(content);
  return json;
}

Json problem_example(const ProblemCode& code) {
  return {{"type", "/problems/" + std::string(code.code)},
          {"title", title_of_code(code.code)},
          {"status", code.status},
          {"detail", code.meaning},
          {"instance", "5f2b-17"},
          {"errors", {{{"code", code.code}, {"detail", code.meaning}}}},
          {"blocked", Json::array()}};
}

/// The codes of an operation by the status that they answer with.
std::map<int, std::vector<const ProblemCode*>> by_status(const Operation& operation, const Route& route) {
  std::map<int, std::vector<const ProblemCode*>> statuses;
  for (const std::string_view code : every_problem(operation, route.method, route.path)) {
    const ProblemCode* known = find_problem_code(code);
    statuses[known->status].push_back(known);
  }
  return statuses;
}

Json problems_json(int status, const std::vector<const ProblemCode*>& codes, bool head) {
  std::string text;
  Json names = Json::array();
  for (const ProblemCode* code : codes) {
    text += (text.empty() ? "`" : "\n\n`") + std::string(code->code) + "`: " + std::string(code->meaning);
    names.push_back(code->code);
  }
  std::vector<std::string> headers = {"Cache-Control"};
  if (status == 429 || status == 503) headers.emplace_back("Retry-After");
  if (status == 401) headers.emplace_back("WWW-Authenticate");
  Json json = {
      {"description", std::move(text)}, {"headers", header_references(headers)}, {"x-problem-codes", std::move(names)}};
  if (!head) {
    json["content"][std::string(problem_type)] = {{"schema", schema::reference("Problem")},
                                                  {"example", problem_example(*codes.front())}};
  }
  return json;
}

Json body_json(const Operation& operation) {
  Json content = Json::object();
  if (operation.request != nullptr) {
    Json schema = schema::reference(operation.request->name);
    if (operation.or_request != nullptr) schema = {{"anyOf", {schema, schema::reference(operation.or_request->name)}}};
    content["application/json"] = {{"schema", std::move(schema)}, {"example", example_of(*operation.request)}};
  }
  if (operation.takes_document) {
    content["application/json"] = {{"schema", schema::reference("Graph")}, {"example", example_graph()}};
  }
  for (const std::string& type : operation.file_types) content[type] = Json::object();
  return {{"required", true}, {"content", std::move(content)}};
}

Json operation_json(const Operation& operation, const Route& route, bool head) {
  Json responses = Json::object();
  for (const Answer& answer : operation.answers) responses[std::to_string(answer.status)] = answer_json(answer, head);
  for (const auto& [status, codes] : by_status(operation, route)) {
    responses[std::to_string(status)] = problems_json(status, codes, head);
  }
  if (head) {
    for (const char* const of_ranges : {"206", "416"}) responses.erase(of_ranges);  // parts are for GET only
  }
  Json json = {{"operationId", operation.id + (head ? "Head" : "")},
               {"tags", {operation.group}},
               {"summary", operation.title + (head ? " (the headers alone)" : "")},
               {"description", operation.doc},
               {"responses", std::move(responses)}};
  for (const Parameter& parameter : operation.parameters) {
    // OpenAPI tells what is accepted by the media types of the answers, and passes over a parameter of that name.
    if (parameter.name != "Accept") json["parameters"].push_back(parameter_json(parameter));
  }
  if (operation.has_body()) json["requestBody"] = body_json(operation);
  json["security"] =
      needs_token(route.path) ? Json::array({Json::object(), {{"token", Json::array()}}}) : Json::array();
  return json;
}

Json problem_schema() {
  using namespace schema;
  return object({{"type", text("The address of the page about the code of the first problem.")},
                 {"title", text("What kind of problem it is.")},
                 {"status", whole("The status of the answer.")},
                 {"detail", text("The sentence of the first problem.")},
                 {"instance", text("The id of the request, as in the log."), true},
                 {"errors", list(reference("ProblemEntry"), "All problems: root causes only, at most 101.")},
                 {"blocked", list(text(""), "Nodes that are well but stand behind one that is not."), true}},
                "An error (RFC 9457).");
}

Json components(const std::map<std::string, const RequestDescription*>& requests) {
  Json schemas = result_schemas();
  schemas["Problem"] = problem_schema();
  for (const auto& [name, request] : requests) schemas[name] = schema_of(*request);
  Json headers = Json::object();
  for (const AnswerHeader& header : answer_headers()) {
    headers[std::string(header.name)] = {{"description", header.doc}, {"schema", {{"type", "string"}}}};
  }
  const Json token = {{"type", "http"},
                      {"scheme", "bearer"},
                      {"description", "The token of `dini serve --token`; a server without one needs none."}};
  return {{"schemas", std::move(schemas)}, {"headers", std::move(headers)}, {"securitySchemes", {{"token", token}}}};
}

}  // namespace

Json openapi_document(std::span<const Route> routes, const std::string& version, const std::string& base) {
  Json paths = Json::object();
  std::map<std::string, const RequestDescription*> requests;
  for (const Route& route : routes) {
    const Operation operation = route.describe();
    Json& path = paths[std::string(route.path)];
    path[to_lower(route.method)] = operation_json(operation, route, false);
    if (route.method == "GET") path["head"] = operation_json(operation, route, true);
    for (const RequestDescription* request : {operation.request, operation.or_request}) {
      if (request != nullptr) requests.emplace(request->name, request);
    }
  }
  return {{"openapi", "3.1.0"},
          {"info",
           {{"title", "Dini"},
            {"version", version},
            {"description",
             "Graphs of geometry nodes, evaluated into Draco-compressed glTF. Every error is an "
             "`application/problem+json`; unknown members are errors everywhere."},
            {"license", {{"name", "MIT"}, {"identifier", "MIT"}}}}},
          {"servers", {{{"url", base.empty() ? "/" : base}, {"description", "This server."}}}},
          {"paths", std::move(paths)},
          {"components", components(requests)}};
}

}  // namespace dini::server

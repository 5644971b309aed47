#include "server/handlers.h"
#include "server/negotiation.h"
#include "server/responses.h"
#include "server/server_limits.h"
#include "server/text.h"

namespace dini::server {

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

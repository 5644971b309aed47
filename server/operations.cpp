#include "server/handlers.h"
#include "server/negotiation.h"
#include "server/responses.h"
#include "server/text.h"

namespace dini::server {

Reply health(const Context&) { return json_reply({{"status", "ok"}}); }

Reply version(const Context& context) {
  const Limits& limits = context.engine().limits();
  const Settings& settings = context.application.settings;
  return json_reply({{"engine", context.engine().catalogue().value("engine", "")},
                     {"limits",
                      {{"body_bytes", limits.body_bytes},
                       {"json_depth", limits.json_depth},
                       {"json_values", limits.json_values},
                       {"string_bytes", limits.string_bytes},
                       {"nodes", limits.nodes},
                       {"links", limits.links},
                       {"samples", limits.samples},
                       {"vertices", limits.vertices},
                       {"triangles", limits.triangles},
                       {"request_bytes", limits.request_bytes},
                       {"work", limits.work},
                       {"cache_bytes", limits.cache_bytes},
                       {"interactive_milliseconds", limits.interactive_milliseconds},
                       {"previews", limits.previews},
                       {"preview_elements", limits.preview_elements},
                       {"preview_points", limits.preview_points},
                       {"asset_bytes", limits.asset_bytes},
                       {"asset_vertices", limits.asset_vertices},
                       {"asset_triangles", limits.asset_triangles},
                       {"asset_store_bytes", limits.asset_store_bytes},
                       {"incoming_bytes", settings.incoming_bytes},
                       {"unsent_bytes", settings.unsent_bytes},
                       {"head_bytes", settings.head_bytes},
                       {"line_bytes", settings.line_bytes},
                       {"header_count", settings.header_count},
                       {"connections", settings.connections},
                       {"known_bytes", settings.known_bytes},
                       {"head_milliseconds", settings.head_deadline.count()},
                       {"body_milliseconds", settings.body_deadline.count()},
                       {"idle_milliseconds", settings.idle_deadline.count()},
                       {"write_milliseconds", settings.write_deadline.count()},
                       {"write_rate", settings.write_rate}}}});
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

#include "server/handlers.h"
#include "server/negotiation.h"
#include "server/responses.h"
#include "server/text.h"

namespace dini::server {

Reply health(Call&) { return json_reply({{"status", "ok"}}); }

Reply version(Call& call) {
  const Limits& limits = call.engine().limits();
  const Settings& settings = call.application.settings;
  return json_reply({{"engine", call.engine().catalogue().value("engine", "")},
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
                       {"large_bodies", settings.large_bodies},
                       {"head_bytes", settings.head_bytes},
                       {"line_bytes", settings.line_bytes},
                       {"header_count", settings.header_count},
                       {"connection_threads", settings.connection_threads},
                       {"head_milliseconds", settings.head_deadline.count()},
                       {"body_milliseconds", settings.body_deadline.count()},
                       {"idle_milliseconds", settings.idle_deadline.count()},
                       {"write_milliseconds", settings.write_deadline.count()}}}});
}

Reply nodes(Call& call) {
  const std::string body = dump(call.engine().catalogue());
  return tagged_json(call, body, "\"" + content_hash(body) + "\"");
}

Reply example_list(Call& call) {
  const std::string body = call.application.examples.list().dump();
  return tagged_json(call, body, "\"" + content_hash(body) + "\"");
}

Reply example(Call& call) {
  const auto* graph = call.application.examples.find(call.argument);
  if (graph == nullptr) {
    return problem_reply(
        Problem{.code = "not-found", .detail = "There is no example of that name; GET /v1/examples lists them."},
        call.exchange);
  }
  const std::string body = graph->dump();
  return tagged_json(call, body, "\"" + content_hash(body) + "\"");
}

Reply example_picture(Call& call) {
  const Examples::Picture* picture = call.application.examples.picture(call.argument);
  if (picture == nullptr) return page_file(call);
  Reply reply;
  reply.headers = {{"ETag", picture->tag}, {"Cache-Control", "no-cache"}};
  if (names_tag(call.header("If-None-Match"), picture->tag)) {
    reply.status = 304;
  } else {
    reply.type = "image/png";
    reply.body = picture->png;
  }
  return reply;
}

Reply tagged_json(const Call& call, const std::string& body, const std::string& tag) {
  Reply reply;
  reply.headers = {{"ETag", tag}, {"Cache-Control", "no-cache"}};
  if (names_tag(call.header("If-None-Match"), tag)) {
    reply.status = 304;
  } else {
    reply.type = "application/json";
    reply.body = body;
  }
  return reply;
}

Result<Json> read_json(const Call& call) {
  const std::string type = call.header("Content-Type");
  if (!equal_ignoring_case(trim(std::string_view(type).substr(0, type.find(';'))), "application/json")) {
    return Problem{.code = "unsupported-media-type", .detail = "Send the body as application/json."};
  }
  return parse_json(call.request.body, call.engine().limits());
}

}  // namespace dini::server

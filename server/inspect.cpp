#include "server/computing.h"
#include "server/handlers.h"
#include "server/request_body.h"
#include "server/responses.h"

namespace dini::server {

void inspect(const Context& context) {
  auto json = read_json(context);
  if (!json) return reply_problems(context, json.problems());
  RequestBody body(*std::move(json), {"graph", "parameters", "node", "output", "full", "deadline_ms"});
  const auto request =
      std::make_shared<const InspectRequest>(InspectRequest{.graph = body.object("graph", true),
                                                            .parameters = body.object("parameters", false),
                                                            .node = body.text("node", true),
                                                            .output = body.text("output", false),
                                                            .full = body.boolean("full")});
  const auto deadline = deadline_of(context, body.positive_integer("deadline_ms"));
  if (!body.well()) return reply_problems(context, std::move(body).problems());

  const Digest key = DigestBuilder().text("inspect").text(context.request().body).finish();
  compute<std::string>(
      context, {.key = key, .deadline = deadline},
      [&engine = context.engine(), request](const Cancel& cancel) { return engine.inspect(*request, cancel); },
      [](const SharedBytes& text) {
        return Reply{.type = "application/json", .body = {text}, .headers = {{"Cache-Control", "no-store"}}};
      });
}

}  // namespace dini::server

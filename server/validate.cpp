#include "server/handlers.h"
#include "server/request_body.h"
#include "server/responses.h"

namespace dini::server {

Reply validate(Call& call) {
  auto json = read_json(call);
  if (!json) return problem_reply(json.problems(), call.exchange);
  RequestBody body(*std::move(json), {"graph", "parameters"});
  const Json graph = body.object("graph", true);
  const Json parameters = body.object("parameters", false);
  if (!body.problems().empty()) return problem_reply(body.problems(), call.exchange);
  Reply reply = json_reply(call.engine().validate(graph, parameters));
  reply.headers.emplace_back("Cache-Control", "no-store");
  return reply;
}

}  // namespace dini::server

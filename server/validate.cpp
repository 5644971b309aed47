#include "server/computing.h"
#include "server/handlers.h"
#include "server/request_body.h"
#include "server/responses.h"

namespace dini::server {

Reply validate(const Context& context) {
  auto json = read_json(context);
  if (!json) return problem_reply(json.problems(), context.exchange());
  RequestBody body(*std::move(json), {"graph", "parameters"});
  const Json graph = body.object("graph", true);
  const Json parameters = body.object("parameters", false);
  if (!body.well()) return problem_reply(std::move(body).problems(), context.exchange());
  const Cancel cancel(deadline_of(context, std::nullopt));
  const Result<Json> verdict = context.engine().validate(graph, parameters, cancel);
  if (!verdict) return problem_reply(verdict.problems(), context.exchange());
  Reply reply = json_reply(*verdict);
  reply.headers.emplace_back("Cache-Control", "no-store");
  return reply;
}

}  // namespace dini::server

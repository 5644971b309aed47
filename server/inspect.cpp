#include "server/computation.h"
#include "server/handlers.h"
#include "server/request_body.h"
#include "server/responses.h"

namespace dini::server {

Reply inspect(Call& call) {
  auto json = read_json(call);
  if (!json) return problem_reply(json.problems(), call.exchange);
  RequestBody body(*std::move(json), {"graph", "parameters", "node", "output", "full", "deadline_ms"});
  const InspectRequest request{.graph = body.object("graph", true),
                               .parameters = body.object("parameters", false),
                               .node = body.text("node", true),
                               .output = body.text("output", false),
                               .full = body.boolean("full")};
  Computation computation(call, body.positive_integer("deadline_ms"));
  if (!body.problems().empty()) return problem_reply(body.problems(), call.exchange);

  const auto pass = computation.enter();
  if (!pass) return problem_reply(pass.problems(), call.exchange);
  const auto value = call.engine().inspect(request, computation.cancel());
  if (!value) return problem_reply(value.problems(), call.exchange);
  Reply reply = json_reply(*value);
  reply.headers.emplace_back("Cache-Control", "no-store");
  return reply;
}

}  // namespace dini::server

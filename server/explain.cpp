#include "server/computing.h"
#include "server/graph_body.h"
#include "server/handlers.h"
#include "server/responses.h"
#include "service/requests/requests.h"
#include "service/requests/schema.h"

namespace dini::server {

Operation describe_explain() {
  return {.id = "explain",
          .group = "Graphs",
          .title = "What an evaluation would do, and why",
          .doc =
              "Takes the body of an evaluation and tells which nodes would run, why, what they are predicted to make, "
              "and how long that takes. The memory is a bound: no evaluation takes more. Never evaluates.",
          .request = &evaluate_description(),
          .answers = {{.doc = "Every node that the output and the previews depend on.",
                       .contents = {{.type = "application/json", .schema = schema::reference("Explanation")}},
                       .headers = {"Cache-Control"}}},
          .problems = codes_of(ProblemKind::graph, {"deadline"})};
}

Reply explain(const Context& context) {
  auto given = read_graph_body(context);
  if (!given) return problem_reply(given.problems(), context.exchange());
  const auto body = read_evaluate_body(std::move(given->json), context.engine());
  if (!body) return problem_reply(body.problems(), context.exchange());
  const Cancel cancel(deadline_of(context, body->deadline_milliseconds));
  const auto prepared = context.engine().prepare(*body, cancel);
  if (!prepared) {
    return problem_reply(prepared.problems(), context.exchange(), context.engine().blocked(*body, cancel));
  }
  Reply reply = json_reply(context.engine().explain(**prepared));
  reply.headers.emplace_back("Cache-Control", "no-store");
  return reply;
}

}  // namespace dini::server

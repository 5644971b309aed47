#include "server/computing.h"
#include "server/graph_body.h"
#include "server/handlers.h"
#include "server/responses.h"
#include "service/requests/requests.h"
#include "service/requests/schema.h"

namespace dini::server {

Operation describe_validate() {
  return {.id = "validate",
          .group = "Graphs",
          .title = "Everything that is wrong with a graph, without evaluating it",
          .doc =
              "Answers with everything that is wrong with a graph at once, the types and axes of every wire, and what "
              "it would cost. Never evaluates. A graph that is wrong is answered 200 too.",
          .request = &validate_description(),
          .answers = {{.doc = "What is known of the graph.",
                       .contents = {{.type = "application/json", .schema = schema::reference("Validation")}},
                       .headers = {"Cache-Control"}}},
          .problems = {"deadline"}};
}

Reply validate(const Context& context) {
  auto given = read_graph_body(context);
  if (!given) return problem_reply(given.problems(), context.exchange());
  const auto body = read_validate_body(std::move(given->json), context.engine());
  if (!body) return problem_reply(body.problems(), context.exchange());
  const Cancel cancel(deadline_of(context, body->deadline_milliseconds));
  context.call->note_graph(body->graph->hash);
  const Result<Json> verdict = context.engine().validate(*body->graph, body->parameters, cancel);
  if (!verdict) return problem_reply(verdict.problems(), context.exchange());
  Reply reply = json_reply(*verdict);
  reply.headers.emplace_back("Cache-Control", "no-store");
  return reply;
}

}  // namespace dini::server

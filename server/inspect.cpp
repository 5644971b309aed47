#include "server/computing.h"
#include "server/graph_body.h"
#include "server/handlers.h"
#include "server/responses.h"
#include "service/identity.h"
#include "service/requests/requests.h"
#include "service/requests/schema.h"

namespace dini::server {

Operation describe_inspect() {
  return {.id = "inspect",
          .group = "Graphs",
          .title = "The value on a wire, in full double precision",
          .doc = "Answers with the value of one output of one node, in full double precision.",
          .parameters = {supersede_key_header()},
          .request = &inspect_description(),
          .answers = {{.doc = "The values and the axes that they run over.",
                       .contents = {{.type = "application/json",
                                     .schema = schema::reference("Inspection"),
                                     .example = {{"type", "number"},
                                                 {"axes", {{{"name", "k"}, {"size", 2}, {"closed", false}}}},
                                                 {"values", {0, 0.5}}}}},
                       .headers = {"Cache-Control"}}},
          .problems = codes_of(ProblemKind::graph),
          .computes = true};
}

void inspect(const Context& context) {
  auto given = read_graph_body(context);
  if (!given) return reply_problems(context, given.problems());
  auto body = read_inspect_body(std::move(given->json), context.engine());
  if (!body) return reply_problems(context, body.problems());
  const auto deadline = deadline_of(context, body->deadline_milliseconds);
  context.call->note_graph(body->graph->hash);
  const auto request = std::make_shared<const InspectRequest>(*std::move(body));

  compute<std::string>(
      context, {.key = identity_of(*request), .deadline = deadline},
      [&engine = context.engine(), request](const Job& job) { return engine.inspect(*request, job); },
      [](const SharedBytes& text) {
        return Reply{.type = "application/json", .body = {text}, .headers = {{"Cache-Control", "no-store"}}};
      });
}

}  // namespace dini::server

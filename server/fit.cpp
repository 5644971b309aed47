#include "server/computing.h"
#include "server/graph_body.h"
#include "server/handlers.h"
#include "server/jobs.h"
#include "service/requests/fit_request.h"

namespace dini::server {

Operation describe_create_fit() {
  return {.id = "fit",
          .group = "Jobs",
          .title = "Parameters found by what is to come of them",
          .doc =
              "Begins a job that looks for values of parameters: with numbers at outputs that are wanted, a mesh to be "
              "like, or numbers to be as small as they can (docs/fit.md). While it runs, the job tells its `progress` "
              "and the `best` values so far; its result is what was found. A `deadline_ms` or `job_milliseconds` ends "
              "it with the best so far.",
          .parameters = {idempotency_key_header()},
          .request = &fit_description(),
          .answers = job_answers(),
          .problems = codes_of(ProblemKind::graph, {"idempotency-key-reused", "busy", "storage-full", "storage-failed",
                                                    "deadline", "shutting-down"})};
}

void create_fit(const Context& context) {
  auto given = read_graph_body(context);
  if (!given) return reply_problems(context, given.problems());
  begin_job(context, std::move(given->json), "", jobs::JobKind::fit);
}

}  // namespace dini::server

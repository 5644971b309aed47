#include "server/computing.h"
#include "server/evaluation.h"
#include "server/graph_body.h"
#include "server/handlers.h"
#include "server/jobs.h"
#include "server/responses.h"
#include "service/identity.h"
#include "service/requests/requests.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

using SharedBody = std::shared_ptr<const EvaluateBody>;

/// What the body of a request says. The very same bytes say the same, so they are not read twice.
Result<SharedBody> read_body(const Context& context, const std::string& format) {
  const Request& request = context.request();
  const Digest bytes =
      DigestBuilder().text("body").text(request.header("Content-Type")).text(format).text(request.body).finish();
  Cache& known = context.application.known;
  if (SharedBody read = known.find<EvaluateBody>(bytes)) return read;
  auto given = read_graph_body(context);
  if (!given) return given.problems();
  auto read = read_evaluate_body(std::move(given->json), context.engine());
  if (!read) return read.problems();
  read->format = format;
  auto body = std::make_shared<const EvaluateBody>(*std::move(read));
  // The same name may mean another graph tomorrow.
  if (!given->names_graph) known.insert<EvaluateBody>(bytes, body, memory_of(*body));
  return SharedBody(std::move(body));
}

}  // namespace

Operation describe_evaluate() {
  return {.id = "evaluate",
          .group = "Graphs",
          .title = "The model of a graph, a preview, a report, or all of them",
          .doc =
              "Answers with the model of an output, a preview of nodes, a report about both, or all of them in one "
              "answer. The bytes of a file depend on the graph, the parameters and the engine only. Only what the "
              "output and the previews depend on has to be well; problems of other nodes are warnings of the "
              "report. But a check that cannot run fails the request, as one that does not hold would.",
          .parameters = {accept_header("What is answered: the file, the report, or both as parts of one answer."),
                         format_parameter(), if_none_match_header(), supersede_key_header(), supersede_header(),
                         prefer_header(), idempotency_key_header()},
          .request = &evaluate_description(),
          .answers = {{.status = 200,
                       .doc = "The file of the model, or without an output that of the preview; the report; or the "
                              "parts `report`, `model` and `preview`, those of them that were asked for.",
                       .contents =
                           [] {
                             std::vector<Content> contents;
                             for (const std::string_view type : evaluation_types(usual_formats())) {
                               contents.push_back({.type = std::string(type)});
                               if (type == "application/json") contents.back().schema = schema::reference("Report");
                             }
                             return contents;
                           }(),
                       .headers = {"ETag", "Cache-Control", "Vary", "Content-Disposition"}},
                      job_answers().front(),
                      not_modified()},
          .problems = job_problems(),
          .computes = true};
}

void evaluate(const Context& context) {
  const Result<Form> form = asked_form(context);
  if (!form) return reply_problems(context, form.problems());
  if (auto problem = wrong_supersede(context.request())) return reply_problems(context, {*std::move(problem)});
  if (prefers_job(context.request())) {
    auto given = read_graph_body(context);
    if (!given) return reply_problems(context, given.problems());
    return begin_job(context, std::move(given->json), form->format);
  }
  const Result<SharedBody> body = read_body(context, form->format);
  if (!body) {
    reply_problems(context, body.problems());
    return take_over(context);  // a wrong request is newer all the same
  }
  answer_evaluation(context, form->type, *body);
}

}  // namespace dini::server

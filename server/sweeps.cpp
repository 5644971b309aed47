#include <algorithm>
#include <array>

#include "jobs/sweep.h"
#include "jobs/sweep_file.h"
#include "jobs/variant_outcome.h"
#include "server/computing.h"
#include "server/graph_body.h"
#include "server/handlers.h"
#include "server/negotiation.h"
#include "server/responses.h"
#include "service/requests/requests.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

constexpr std::string_view line_type = "application/x-ndjson";
constexpr std::string_view file_type = "model/gltf-binary";

using SharedRequest = std::shared_ptr<const jobs::SweepRequest>;
using SharedCost = std::shared_ptr<const jobs::SweepCost>;

/// Writes the line of each variant into the body of an answer.
class LineWriter final : public jobs::LineTaker {
 public:
  LineWriter(Application& application, std::shared_ptr<BodyWriter> body)
      : application_(application), body_(std::move(body)) {}

  bool take(store::JobLine line) override {
    for (const SharedFile& file : line.files) application_.artifacts.add(file);
    return body_->add(line.text + "\n");
  }

  bool has_room(std::function<void()> resume) override { return body_->has_room(std::move(resume)); }

  void end(const Problems& reasons, std::size_t next) override {
    if (!reasons.empty()) {
      body_->add(dump({{"status", "stopped"}, {"next", next}, {"errors", to_json(reasons)}}) + "\n");
    }
    body_->finish();
  }

 private:
  Application& application_;
  std::shared_ptr<BodyWriter> body_;
};

/// When a sweep ends at the latest that is answered line by line.
jobs::Flights::Clock::time_point end_of(const Context& context, std::optional<std::int64_t> milliseconds) {
  const auto limit = static_cast<std::int64_t>(context.engine().limits().sweep_milliseconds);
  return context.exchange().started + std::chrono::milliseconds(std::min(milliseconds.value_or(limit), limit));
}

/// The answer, which goes on being written after this.
Reply begin(const Context& context, const jobs::SweepRequest& request, const jobs::SweepCost& cost) {
  BodyStream stream = make_body_stream();
  auto lines = std::make_unique<LineWriter>(context.application, stream.writer);
  const auto made = context.application.sweeps.make(request, cost, std::move(lines), jobs::Sweeps::Waiting::answer);
  if (!made) return problem_reply(made.problems(), context.exchange());
  const std::shared_ptr<jobs::Sweep>& sweep = *made;
  stream.writer->when_abandoned([weak = std::weak_ptr(sweep)] {
    if (const auto left = weak.lock()) left->stop(StopReason::client_gone);
  });
  sweep->start();
  return {.type = std::string(line_type),
          .stream = std::move(stream.reader),
          .headers = {{"Cache-Control", "no-store"}, {"X-Accel-Buffering", "no"}}};
}

/// The same body may name a graph that is another one by now.
Digest key_of(std::string_view work, const Context& context, const jobs::SweepRequest& request) {
  return DigestBuilder().text(work).text(context.request().body).digest(request.base.graph->hash).finish();
}

/// Lets all variants be put into one file, which is the answer.
void begin_file(const Context& context, const SharedRequest& request, const SharedCost& cost) {
  const Digest key = key_of("sweep file", context, *request);
  const std::size_t at_once = std::min(request->variants.size() - request->first, jobs::most_at_once());
  ask<File>(
      context, {.key = key, .bytes = cost->bytes * at_once, .work = cost->work, .deadline = request->deadline},
      [&engine = context.engine(), request](const Job& job) { return jobs::sweep_file(engine, *request, job); },
      [](const SharedFile& file) {
        return Reply{.type = file->media_type,
                     .body = {file->bytes},
                     .headers = {{"Cache-Control", "no-store"},
                                 {"Vary", "Accept"},
                                 {"Content-Disposition", "inline; filename=\"variants" + file->extension + "\""}}};
      });
}

/// What is asked for, read and checked as far as that needs no variant.
Result<jobs::SweepRequest> read_request(const Context& context, bool as_file) {
  auto given = read_graph_body(context);
  if (!given) return given.problems();
  // Only workers read it again.
  SharedBytes text = context.application.settings.queue ? share(dump(given->json)) : nullptr;
  auto read = jobs::read_sweep_request(std::move(given->json), context.engine());
  if (!read) return read.problems();
  const auto end = as_file ? deadline_of : end_of;
  const auto deadline = end(context, read->deadline_milliseconds);
  auto asked = std::get<jobs::SweepRequest>(std::move(read->asked));
  asked.deadline = deadline;
  asked.text = std::move(text);
  if (as_file && asked.base.without_output) {
    return Problem{.code = "nothing-to-export",
                   .detail = "Without 'models' there is nothing to put into a file; ask for lines.",
                   .pointer = "/models",
                   .in_request = true};
  }
  return asked;
}

}  // namespace

Operation describe_sweep() {
  return {
      .id = "sweep",
      .group = "Graphs",
      .title = "One graph for many settings of its parameters",
      .doc =
          "Evaluates a graph for every variant of a grid, a zip or a list of settings, and answers with one line of "
          "JSON for each, in their order, as they are done. What variants have in common is computed once. A "
          "variant that fails has its errors in its line and the others go on. Everything is checked first: a "
          "sweep that would take more than `sweep_work` is refused before it begins. A sweep that is stopped ends "
          "with a line that says why and which variant is the `next`; a body that ends without its last line was "
          "cut off. Both go on with `first`. As `model/gltf-binary` it is one file with a node for each variant, "
          "within `interactive_milliseconds`; a variant that fails is a problem then.",
      .parameters = {accept_header("Lines of JSON, or one file with a node for each variant.")},
      .request = &sweep_description(),
      .answers = {{.doc =
                       "A line for each variant: its index, its parameters, its status, and what came of it; or a file "
                       "whose nodes are the variants, with `index` and `parameters` in their extras.",
                   .contents = {{.type = std::string(line_type), .schema = schema::reference("SweepLine")},
                                {.type = std::string(file_type)}},
                   .headers = {"Cache-Control"}}},
      .problems = codes_of(ProblemKind::graph, {"not-acceptable", "deadline", "shutting-down", "queue-failed"})};
}

void sweep(const Context& context) {
  constexpr std::array types = {line_type, file_type};
  const auto type = accepted_type(context.request().header("Accept"), types);
  if (!type) return reply_problems(context, type.problems());
  const bool as_file = *type == file_type;
  auto read = read_request(context, as_file);
  if (!read) return reply_problems(context, read.problems());
  context.call->note_graph(read->base.graph->hash);
  const auto request = std::make_shared<const jobs::SweepRequest>(*std::move(read));
  const Digest key = key_of("sweep cost", context, *request);
  ask<jobs::SweepCost>(
      context, {.key = key, .deadline = request->deadline},
      [&engine = context.engine(), request](const Job& job) { return jobs::predict(engine, *request, job); },
      [context, request, as_file](const SharedCost& cost) -> std::optional<Reply> {
        if (!as_file) return begin(context, *request, *cost);
        begin_file(context, request, cost);
        return std::nullopt;
      });
}

}  // namespace dini::server

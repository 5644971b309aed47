#include "jobs/sweep.h"
#include "server/computing.h"
#include "server/handlers.h"
#include "server/responses.h"
#include "server/sweep_line.h"
#include "service/requests/requests.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

constexpr std::string_view line_type = "application/x-ndjson";

/// Writes the line of each variant into the body of an answer.
class LineWriter final : public jobs::Sweep::Taker {
 public:
  LineWriter(Application& application, std::shared_ptr<BodyWriter> body)
      : application_(application), body_(std::move(body)) {}

  bool take(const jobs::VariantOutcome& outcome) override {
    return body_->add(sweep_line(application_, outcome) + "\n");
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

jobs::Flights::Clock::time_point end_of(const Context& context, std::optional<std::int64_t> milliseconds) {
  const auto limit = static_cast<std::int64_t>(context.engine().limits().sweep_milliseconds);
  return context.exchange().started + std::chrono::milliseconds(std::min(milliseconds.value_or(limit), limit));
}

/// The answer, which goes on being written after this.
Reply begin(const Context& context, const jobs::SweepRequest& request, const jobs::SweepCost& cost) {
  BodyStream stream = make_body_stream();
  auto lines = std::make_unique<LineWriter>(context.application, stream.writer);
  const auto sweep =
      std::make_shared<jobs::Sweep>(context.engine(), context.application.flights, request, cost, std::move(lines));
  stream.writer->when_abandoned([weak = std::weak_ptr(sweep)] {
    if (const auto left = weak.lock()) left->stop(StopReason::client_gone);
  });
  sweep->start();
  return {.type = std::string(line_type),
          .stream = std::move(stream.reader),
          .headers = {{"Cache-Control", "no-store"}, {"X-Accel-Buffering", "no"}}};
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
          "cut off. Both go on with `first`.",
      .request = &sweep_description(),
      .answers = {{.doc = "A line for each variant: its index, its parameters, its status, and what came of it.",
                   .contents = {{.type = std::string(line_type), .schema = schema::reference("SweepLine")}},
                   .headers = {"Cache-Control"}}},
      .problems = codes_of(ProblemKind::graph, {"deadline", "shutting-down"})};
}

void sweep(const Context& context) {
  auto json = read_json(context);
  if (!json) return reply_problems(context, json.problems());
  auto read = jobs::read_sweep_request(*std::move(json), context.engine());
  if (!read) return reply_problems(context, read.problems());
  const auto deadline = end_of(context, read->deadline_milliseconds);
  auto asked = std::get<jobs::SweepRequest>(std::move(read->asked));
  context.call->note_graph(asked.base.graph->hash);
  asked.deadline = deadline;
  const auto request = std::make_shared<const jobs::SweepRequest>(std::move(asked));
  const Digest key = DigestBuilder().text("sweep cost").text(context.request().body).finish();
  ask<jobs::SweepCost>(
      context, {.key = key, .deadline = deadline},
      [&engine = context.engine(), request](const Job& job) { return jobs::predict(engine, *request, job); },
      [context, request](const std::shared_ptr<const jobs::SweepCost>& cost) {
        return begin(context, *request, *cost);
      });
}

}  // namespace dini::server

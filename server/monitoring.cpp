// What those who operate a server ask it: whether it is ready, and its numbers.

#include "jobs/compute_queue.h"
#include "jobs/process_memory.h"
#include "jobs/queue_identity.h"
#include "queue/dead_tasks.h"
#include "server/connections.h"
#include "server/handlers.h"
#include "server/metrics.h"
#include "server/responses.h"
#include "server/wrong_tokens.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

constexpr const char* metrics_type = "text/plain; version=0.0.4; charset=utf-8";

void add_cache(std::vector<Reading>& readings, const std::string& what, const std::string& of,
               const Engine::CacheState& state) {
  readings.push_back({"dini_" + what + "_bytes", "Memory that " + of + " take.", static_cast<double>(state.bytes)});
  readings.push_back(
      {"dini_" + what + "_entries", "How many " + of + " are kept.", static_cast<double>(state.entries)});
  readings.push_back({"dini_" + what + "_evictions_total", "How many " + of + " had to make room.",
                      static_cast<double>(state.evictions), true});
}

/// What lies in the queue before the workers, as far as it tells within a moment.
void add_queue(std::vector<Reading>& readings, const Application& application) {
  if (application.queue_link == nullptr) return;
  const auto add = [&](const char* name, const char* help, auto value, bool counts = false) {
    readings.push_back({name, help, static_cast<double>(value), counts});
  };
  const jobs::QueueCounts& counts = application.queued_sweeps->counts();
  add("dini_queue_up", "Whether the queue before the workers answers.", application.queue_link->is_well() ? 1 : 0);
  add("dini_queue_sweeps_total", "Sweeps that were given to the queue, again ones included.", counts.submitted.load(),
      true);
  add("dini_queue_lines_total", "Lines that came from workers.", counts.lines.load(), true);
  add("dini_queue_damaged_total", "Of these, lines that were damaged and computed again.", counts.damaged.load(), true);
  const queue::ResultStore::Counts& results = application.shared_results->counts();
  add("dini_shared_hits_total", "Results that another server had computed.", results.hits.load(), true);
  add("dini_shared_misses_total", "Results that were asked for and not there.", results.misses.load(), true);
  add("dini_shared_damaged_total", "Results that were damaged and computed again.", results.damaged.load(), true);
  add("dini_shared_kept_total", "Results that were put there.", results.kept.load(), true);
  if (!application.queue_link->is_well()) return;
  queue::Connection connection(application.queue_link->address(), {});
  const auto state = queue::queue_state(connection, jobs::queue_identity(application.engine));
  if (!state) return application.queue_link->note(state.error());
  add("dini_queue_workers", "Workers of this engine that are well.", state->workers);
  add("dini_queue_waiting_interactive", "Variants that wait or are computed, for who waits for them.",
      state->interactive);
  add("dini_queue_waiting_batch", "Variants that wait or are computed, of jobs.", state->batch);
  add("dini_queue_dead", "Variants that ended as many workers as they may.", state->dead);
  add("dini_queue_done_total", "Variants that workers have computed.", state->counted, true);
  add("dini_queue_twice_total", "Variants that another worker had computed as well.", state->twice, true);
  add("dini_queue_again_total", "Variants that were given to another worker.", state->again, true);
}

std::vector<Reading> readings_of(const Application& application) {
  const jobs::ComputeQueue::Load load = application.queue.load();
  const jobs::Flights::Count flights = application.flights.count();
  const jobs::JobRunner::Load jobs = application.jobs.load();
  std::vector<Reading> readings = {
      {"dini_connections", "Connections that are open.", static_cast<double>(application.connections.open())},
      {"dini_computing", "Evaluations that run.", static_cast<double>(load.running)},
      {"dini_waiting", "Evaluations that wait for a place.", static_cast<double>(load.waiting)},
      {"dini_promised_bytes", "Memory that is predicted for what runs.", static_cast<double>(load.bytes)},
      {"dini_jobs_running", "Jobs that are done.", static_cast<double>(jobs.running)},
      {"dini_jobs_waiting", "Jobs that wait for their turn.", static_cast<double>(jobs.waiting)},
      {"dini_computations_total", "Computations that were begun.", static_cast<double>(flights.begun), true},
      {"dini_joined_total", "Requests that joined a computation that was begun for another.",
       static_cast<double>(flights.joined), true},
      {"dini_wrong_tokens_total", "Requests that carried a wrong token.",
       static_cast<double>(application.wrong_tokens.total()), true},
      {"dini_resident_bytes", "Memory that the process holds.", static_cast<double>(jobs::resident_bytes())}};
  add_queue(readings, application);
  add_cache(readings, "cache", "results of nodes", application.engine.cache_state());
  add_cache(readings, "known", "requests that were read before",
            {application.known.bytes(), application.known.size(), application.known.evictions()});
  const std::vector<Engine::NodeTime> times = application.engine.node_times();
  for (const Engine::NodeTime& time : times) {
    readings.push_back({"dini_node_runs_total", "How often nodes of a type were computed.",
                        static_cast<double>(time.runs), true, time.type});
  }
  for (const Engine::NodeTime& time : times) {
    readings.push_back(
        {"dini_node_seconds_total", "How long nodes of a type took to compute.", time.seconds, true, time.type});
  }
  return readings;
}

/// Why no more requests should be sent here just now; nothing when they should.
std::optional<Problem> reason_to_wait(const Application& application) {
  if (application.connections.is_draining()) {
    return Problem{.code = "shutting-down", .detail = "The server is about to stop."};
  }
  if (auto fault = application.graphs.check_writing()) return fault;
  const jobs::ComputeQueue::Load load = application.queue.load();
  if (load.waiting >= application.queue.size().waiting && load.waiting > 0) {
    return Problem{.code = "busy", .detail = "Every place to compute and the whole queue before them are taken."};
  }
  return std::nullopt;
}

}  // namespace

Operation describe_ready() {
  return {.id = "ready",
          .group = "Service",
          .title = "Whether to send requests here",
          .doc =
              "For load balancers: 503 while the server is about to stop, while graphs cannot be stored, and while "
              "the queue before the places to compute is full. `degraded` says that sweeps cannot be computed by the "
              "workers just now; everything else goes on.",
          .answers = {{.doc = "Yes.",
                       .contents = {{.type = "application/json",
                                     .schema = schema::object({{"status", schema::word({"ready"}, "Always `ready`.")},
                                                               {"degraded",
                                                                schema::list(schema::word({"queue"}, "A part."),
                                                                             "What does not work just now while all "
                                                                             "else does; absent when nothing is."),
                                                                true}}),
                                     .example = {{"status", "ready"}}}},
                       .headers = {"Cache-Control"}}},
          .problems = {"shutting-down", "storage-failed", "storage-full", "busy"},
          .takes_any_query = true};
}

Reply ready(const Context& context) {
  if (auto reason = reason_to_wait(context.application)) return problem_reply(*std::move(reason), context.exchange());
  Json status = {{"status", "ready"}};
  const queue::Link* const link = context.application.queue_link;
  if (link != nullptr && !link->is_well()) status["degraded"] = {"queue"};
  Reply reply = json_reply(status);
  reply.headers.emplace_back("Cache-Control", "no-store");
  return reply;
}

Operation describe_metrics() {
  return {.id = "metrics",
          .group = "Service",
          .title = "Counts and times, for Prometheus",
          .doc =
              "Requests by route, method and status, how long they took, and what is computed, kept and open at this "
              "moment, in the text format of Prometheus.",
          .answers = {{.doc = "All numbers.", .contents = {{.type = "text/plain"}}, .headers = {"Cache-Control"}}}};
}

Reply metrics(const Context& context) {
  Reply reply{.type = metrics_type, .headers = {{"Cache-Control", "no-store"}}};
  reply.body = {share(context.application.metrics.text(readings_of(context.application)))};
  return reply;
}

}  // namespace dini::server

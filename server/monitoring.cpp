// What those who operate a server ask it: whether it is ready, and its numbers.

#include "jobs/compute_queue.h"
#include "jobs/process_memory.h"
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
              "the queue before the places to compute is full.",
          .answers = {{.doc = "Yes.",
                       .contents = {{.type = "application/json",
                                     .schema = schema::object({{"status", schema::word({"ready"}, "Always `ready`.")}}),
                                     .example = {{"status", "ready"}}}},
                       .headers = {"Cache-Control"}}},
          .problems = {"shutting-down", "storage-failed", "storage-full", "busy"},
          .takes_any_query = true};
}

Reply ready(const Context& context) {
  if (auto reason = reason_to_wait(context.application)) return problem_reply(*std::move(reason), context.exchange());
  Reply reply = json_reply({{"status", "ready"}});
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

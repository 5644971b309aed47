// What those who operate a server ask it.

#include <future>
#include <sstream>

#include "tests/server/fixture.h"

using namespace dini;
using namespace dini::support;

namespace {

/// The value of a line of the metrics; -1 when there is none.
double metric(int port, const std::string& name) {
  std::istringstream lines(get(port, "/metrics")->body);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(name + " ")) return std::stod(line.substr(name.size() + 1));
  }
  return -1;
}

std::string requests(const std::string& method, const std::string& route, const std::string& status) {
  return "dini_requests_total{method=\"" + method + "\",route=\"" + route + "\",status=\"" + status + "\"}";
}

}  // namespace

TEST_CASE("Probes are answered by address and without the token, metrics are not") {
  auto settings = quick_settings();
  settings.token = "swordfish";
  const Running server(settings);
  for (const std::string path : {"/healthz", "/readyz"}) {
    CHECK(ask(server.port(), "GET " + path + " HTTP/1.1\r\nHost: 10.1.2.3:8080\r\n\r\n")->status == 200);
  }
  CHECK(get(server.port(), "/metrics")->status == 401);
  CHECK(get(server.port(), "/metrics", "Authorization: bearer swordfish\r\n")->status == 200);
  CHECK(ask(server.port(), "GET /metrics HTTP/1.1\r\nHost: 10.1.2.3\r\nAuthorization: Bearer swordfish\r\n\r\n")
            ->status == 421);
}

TEST_CASE("A server with a full queue is not ready, and is ready again afterwards") {
  const Running server;  // one slot, one place in the queue
  const std::size_t before = toy::counters().started;
  Client running(server.port()), waiting(server.port());
  running.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}})));
  REQUIRE(eventually([&] { return toy::counters().started > before; }));
  CHECK(get(server.port(), "/readyz")->status == 200);
  waiting.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}, {"bytes", 2}})));
  REQUIRE(eventually([&] { return get(server.port(), "/readyz")->status == 503; }));
  CHECK(get(server.port(), "/readyz")->code() == "busy");
  CHECK(metric(server.port(), "dini_computing") == 1);
  CHECK(metric(server.port(), "dini_waiting") == 1);
  running.close();
  waiting.close();
  CHECK(eventually([&] { return get(server.port(), "/readyz")->status == 200; }));
}

TEST_CASE("A server that is about to stop is not ready") {
  Running server;
  const std::size_t before = toy::counters().started;
  Client busy(server.port()), late(server.port());
  busy.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 300}})));
  late.send("GET /readyz HTTP/1.1\r\n");
  REQUIRE(eventually([&] { return toy::counters().started > before; }));
  Client idle(server.port());
  REQUIRE(get(server.port(), "/healthz")->status == 200);  // who came before has been let in
  auto stopping = std::async(std::launch::async, [&] { server.stop(); });
  REQUIRE(idle.closed());
  late.send("Host: localhost\r\n\r\n");
  const auto answer = late.receive();
  REQUIRE(answer);
  CHECK(answer->status == 503);
  CHECK(answer->code() == "shutting-down");
  stopping.wait();
}

TEST_CASE("Requests are counted by route, method and status, whatever their addresses are") {
  const Running server;
  for (int i = 0; i < 3; ++i) post(server.port(), "/v1/evaluate", toy_body({{"bytes", i}}));
  post(server.port(), "/v1/evaluate", "{");
  get(server.port(), "/v1/graphs/none");
  get(server.port(), "/v1/graphs/other/versions");
  get(server.port(), "/v1/graphs/other/versions?x=1");
  get(server.port(), "/nowhere/at/all");
  ask(server.port(), "NONSENSE\r\n\r\n");
  CHECK(eventually([&] { return metric(server.port(), requests("POST", "/v1/evaluate", "200")) == 3; }));
  CHECK(eventually([&] { return metric(server.port(), requests("POST", "/v1/evaluate", "400")) == 1; }));
  CHECK(eventually([&] { return metric(server.port(), requests("GET", "/v1/graphs/{id}", "404")) == 1; }));
  CHECK(eventually([&] { return metric(server.port(), requests("GET", "/v1/graphs/{id}/versions", "404")) == 1; }));
  CHECK(eventually([&] { return metric(server.port(), requests("GET", "/v1/graphs/{id}/versions", "422")) == 1; }));
  CHECK(eventually([&] { return metric(server.port(), requests("GET", "other", "404")) == 1; }));
  CHECK(metric(server.port(), "dini_request_seconds_count{route=\"/v1/evaluate\"}") == 4);
  CHECK(metric(server.port(), "dini_computations_total") == 3);
  CHECK(metric(server.port(), "dini_resident_bytes") > 1'000'000);
  CHECK(metric(server.port(), "dini_build_info{version=\"0.0.0-toy\"}") == 1);
  CHECK(get(server.port(), "/metrics")->header("content-type") == "text/plain; version=0.0.4; charset=utf-8");
}

TEST_CASE("Who was late for want of a place is told when to try again, and who was late at work is not") {
  const Running server;  // one slot, one place in the queue
  const std::size_t before = toy::counters().started;
  Client running(server.port());
  running.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}})));
  REQUIRE(eventually([&] { return toy::counters().started > before; }));
  auto body = Json::parse(toy_body({{"bytes", 2}}));
  body["deadline_ms"] = 30;
  const auto waited = post(server.port(), "/v1/evaluate", body.dump());
  REQUIRE(waited);
  CHECK(waited->status == 504);
  CHECK(waited->header("retry-after") == "1");
  CHECK(waited->body.find("within the deadline of 30 ms: it waited for a place") != std::string::npos);
  running.close();
  REQUIRE(eventually([&] { return metric(server.port(), "dini_computing") == 0; }));
  body = Json::parse(toy_body({{"milliseconds", 60'000}, {"bytes", 3}}));
  body["deadline_ms"] = 200;
  const auto worked = post(server.port(), "/v1/evaluate", body.dump());
  REQUIRE(worked);
  CHECK(worked->status == 504);
  CHECK(worked->header("retry-after").empty());
}

TEST_CASE("The numbers tell of jobs that run and wait") {
  const Running server;
  CHECK(metric(server.port(), "dini_jobs_running") == 0);
  const auto begin = [&](int milliseconds) {
    REQUIRE(post(server.port(), "/v1/jobs", toy_body({{"milliseconds", milliseconds}}))->status == 202);
  };
  begin(60'000);
  REQUIRE(eventually([&] { return metric(server.port(), "dini_jobs_running") == 1; }));
  begin(60'001);
  CHECK(metric(server.port(), "dini_jobs_waiting") == 1);
}

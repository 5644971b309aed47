// Long work over a running server: begun, asked about, followed, stopped, and found again after a restart.

#include <set>

#include "service/requests/description.h"
#include "tests/server/fixture.h"

using namespace dini;
using namespace dini::support;

namespace {

std::optional<Answer> begin(int port, const std::string& body, const std::string& headers = "") {
  return post(port, "/v1/jobs", body, headers);
}

std::string address_of(const std::optional<Answer>& begun) {
  REQUIRE(begun);
  CAPTURE(begun->body);
  REQUIRE(begun->status == 202);
  CHECK(begun->header("location") == begun->json()["address"]);
  return begun->json()["address"];
}

std::string state_of(int port, const std::string& address) { return get(port, address)->json().value("state", ""); }

bool reaches(int port, const std::string& address, const std::string& state) {
  return eventually([&] { return state_of(port, address) == state; });
}

std::optional<Answer> cancel(int port, const std::string& address) { return post(port, address + "/cancel", ""); }

/// A graph of the toy engine with a parameter that changes nothing.
Json slow_graph(int milliseconds) {
  Json graph = Json::parse(toy_body({{"milliseconds", milliseconds}}))["graph"];
  graph["parameters"] = {{"x", {{"type", "integer"}}}};
  return graph;
}

Json numbers(int count) {
  Json values = Json::array();
  for (int i = 0; i < count; ++i) values.push_back(i);
  return values;
}

std::string slow_sweep(int milliseconds, int count) {
  return Json{{"graph", slow_graph(milliseconds)}, {"grid", {{"x", numbers(count)}}}}.dump();
}

/// The data of the events of a stream.
std::vector<Json> jobs_in(const std::string& events) {
  std::vector<Json> jobs;
  for (std::size_t at = events.find("data: "); at != std::string::npos; at = events.find("data: ", at + 1)) {
    jobs.push_back(Json::parse(events.substr(at + 6, events.find('\n', at) - at - 6)));
  }
  return jobs;
}

server::Settings kept_in(const Folder& folder) {
  auto settings = quick_settings();
  settings.data = folder.path() / "data";
  return settings;
}

}  // namespace

TEST_CASE("A job is answered before it is done, and has the bytes of an evaluation") {
  const RunningReal server;
  const std::string body = Json{{"graph", example_graph()}, {"parameters", {{"reach", 0.7}}}}.dump();
  const std::string address = address_of(begin(server.port(), body));
  REQUIRE(reaches(server.port(), address, "succeeded"));
  const Json job = get(server.port(), address)->json();
  CHECK(job["kind"] == "evaluate");
  CHECK(job["progress"] == 1);
  CHECK(job["errors"] == Json::array());
  CHECK(job["created"] <= job["started"]);
  CHECK(job["started"] <= job["finished"]);
  const auto file = get(server.port(), job["result"]);
  REQUIRE(file);
  CHECK(file->header("content-type") == "model/gltf-binary");
  CHECK(file->body == post(server.port(), "/v1/evaluate", body)->body);
  const auto report = get(server.port(), job["result"], "Accept: application/json\r\n");
  CHECK(report->json().contains("nodes"));
  CHECK(get(server.port(), job["result"], "Accept: model/stl\r\n")->status == 406);
}

TEST_CASE("An evaluation becomes a job when its client prefers so, in the format that it accepts") {
  const RunningReal server;
  const std::string body = Json{{"graph", example_graph()}}.dump();
  const auto begun =
      post(server.port(), "/v1/evaluate", body, "Prefer: wait=5, respond-async\r\nAccept: model/gltf+json\r\n");
  const std::string address = address_of(begun);
  CHECK(begun->header("preference-applied") == "respond-async");
  REQUIRE(reaches(server.port(), address, "succeeded"));
  const auto file = get(server.port(), address + "/result");
  CHECK(file->header("content-type") == "model/gltf+json");
  CHECK(file->body == post(server.port(), "/v1/evaluate", body, "Accept: model/gltf+json\r\n")->body);
  CHECK(post(server.port(), "/v1/evaluate", body, "Prefer: wait=5\r\n")->status == 200);
}

TEST_CASE("What is wrong with a job is said before it is kept") {
  Limits limits;
  limits.sweep_work = 1'000'000;
  const RunningReal server(quick_settings(), limits);
  CHECK(begin(server.port(), "{}")->code() == "required-input-missing");
  CHECK(begin(server.port(), "[")->code() == "not-json");
  const Json wrong = {{"graph", example_graph()}, {"parameters", {{"raech", 1}}}};
  const auto refused = begin(server.port(), wrong.dump());
  CHECK(refused->status == 422);
  CHECK(refused->code() == "unknown-parameter");
  CHECK(begin(server.port(), Json{{"graph", example_graph()}, {"list", {1}}}.dump())->code() == "type-mismatch");
  const Json large = {{"graph", example_graph()}, {"grid", {{"reach", numbers(10'000)}}}};
  CHECK(begin(server.port(), large.dump())->code() == "limit-exceeded");
  CHECK(begin(server.port(), Json{{"graph", example_graph()}}.dump(), "Accept: text/html\r\n")->status == 406);
}

TEST_CASE("A job that fails says why, and its result is that problem") {
  const Running server;
  const std::string address = address_of(begin(server.port(), toy_body({{"problem", "degenerate"}})));
  REQUIRE(reaches(server.port(), address, "failed"));
  const Json job = get(server.port(), address)->json();
  CHECK(job["errors"][0]["code"] == "degenerate");
  CHECK_FALSE(job.contains("result"));
  const auto result = get(server.port(), address + "/result");
  CHECK(result->status == 422);
  CHECK(result->code() == "degenerate");
}

TEST_CASE("An evaluation that takes too long for a job fails by its deadline") {
  auto settings = quick_settings();
  settings.job_deadline = std::chrono::milliseconds(200);
  const Running server(settings);
  const std::string address = address_of(begin(server.port(), toy_body({{"milliseconds", 60'000}})));
  REQUIRE(reaches(server.port(), address, "failed"));
  CHECK(get(server.port(), address)->json()["errors"][0]["code"] == "deadline");
  CHECK(get(server.port(), address + "/result")->status == 504);
}

TEST_CASE("A job is stopped while it runs and taken back while it waits, and what has ended stays") {
  const Running server;
  const std::size_t canceled = toy::counters().canceled;
  const std::string first = address_of(begin(server.port(), toy_body({{"milliseconds", 60'000}})));
  const std::string second = address_of(begin(server.port(), toy_body({{"milliseconds", 60'001}})));
  REQUIRE(reaches(server.port(), first, "running"));
  CHECK(state_of(server.port(), second) == "queued");
  CHECK(get(server.port(), first + "/result")->code() == "job-unfinished");
  CHECK(cancel(server.port(), second)->json()["state"] == "canceled");
  CHECK(cancel(server.port(), first)->status == 200);
  REQUIRE(reaches(server.port(), first, "canceled"));
  CHECK(eventually([&] { return toy::counters().canceled == canceled + 1; }));
  CHECK(get(server.port(), first + "/result")->code() == "canceled");
  CHECK(cancel(server.port(), first)->json()["state"] == "canceled");
  const std::string third = address_of(begin(server.port(), toy_body({{"bytes", 4}})));
  REQUIRE(reaches(server.port(), third, "succeeded"));
  CHECK(cancel(server.port(), third)->json()["state"] == "succeeded");
}

TEST_CASE("A sweep as a job has a line for every variant, those that fail too") {
  const RunningReal server;
  const Json body = {{"graph", example_graph()}, {"list", {{{"reach", 0.5}}, {{"raech", 1}}, {{"reach", 1}}}}};
  const std::string address = address_of(begin(server.port(), body.dump()));
  REQUIRE(reaches(server.port(), address, "succeeded"));
  const Json job = get(server.port(), address)->json();
  CHECK(job["kind"] == "sweep");
  CHECK(job["variants"] == Json{{"total", 3}, {"done", 3}, {"failed", 1}});
  const auto result = get(server.port(), job["result"]);
  CHECK(result->header("content-type") == "application/x-ndjson");
  CHECK(result->lines() == post(server.port(), "/v1/sweeps", body.dump())->lines());
}

TEST_CASE("A sweep of several outputs as a job keeps the files of all of them") {
  const Folder folder;
  Json graph = example_graph();
  graph["nodes"]["copy"] = graph["nodes"]["out"];
  graph["nodes"]["copy"]["inputs"]["draco"] = false;
  const Json body = {{"graph", graph}, {"list", {{{"reach", 0.5}}, {{"reach", 1}}}}, {"outputs", {"copy", "out"}}};
  std::string address;
  std::vector<Json> lines;
  {
    const RunningReal server(kept_in(folder));
    lines = post(server.port(), "/v1/sweeps", body.dump())->lines();
    address = address_of(begin(server.port(), body.dump()));
    REQUIRE(reaches(server.port(), address, "succeeded"));
    Json wrong = body;
    wrong["outputs"] = {"copy", "ouz"};
    CHECK(begin(server.port(), wrong.dump())->code() == "unknown-output");
  }
  REQUIRE(lines.size() == 2);
  const RunningReal server(kept_in(folder));
  CHECK(get(server.port(), address + "/result")->lines() == lines);
  std::set<std::string> files;
  for (const Json& line : lines) {
    for (const Json& output : line["outputs"]) {
      const auto file = get(server.port(), output["model"]["address"]);
      CHECK(file->status == 200);
      files.insert(file->body);
    }
  }
  CHECK(files.size() == 4);
}

TEST_CASE("A sweep as a job is stopped within its variants") {
  const Running server;
  const std::string address = address_of(begin(server.port(), slow_sweep(50, 2'000)));
  REQUIRE(eventually([&] { return get(server.port(), address)->json()["variants"]["done"] > 2; }));
  CHECK(cancel(server.port(), address)->status == 200);
  REQUIRE(reaches(server.port(), address, "canceled"));
  REQUIRE(eventually([&] { return toy::counters().started == toy::counters().finished; }));
  CHECK(get(server.port(), address)->json()["variants"]["done"] < 2'000);
}

TEST_CASE("The same request with the same key is the same job, and another request with it is refused") {
  const Running server;
  const std::string key = "Idempotency-Key: night-1\r\n";
  const std::string address = address_of(begin(server.port(), toy_body({{"bytes", 5}}), key));
  CHECK(address_of(begin(server.port(), toy_body({{"bytes", 5}}), key)) == address);
  CHECK(address_of(begin(server.port(), toy_body({{"bytes", 5}}))) != address);
  const auto other = begin(server.port(), toy_body({{"bytes", 6}}), key);
  CHECK(other->status == 422);
  CHECK(other->code() == "idempotency-key-reused");
  CHECK(begin(server.port(), toy_body({{"bytes", 5}}), "Idempotency-Key: a b\r\n")->code() == "out-of-range");
  CHECK(begin(server.port(), toy_body({{"bytes", 5}}), "Idempotency-Key: " + std::string(256, 'x') + "\r\n")->code() ==
        "out-of-range");
}

TEST_CASE("Only so many jobs wait") {
  auto settings = quick_settings();
  settings.jobs_waiting = 2;
  const Running server(settings);
  const std::string first = address_of(begin(server.port(), toy_body({{"milliseconds", 60'000}})));
  REQUIRE(reaches(server.port(), first, "running"));
  address_of(begin(server.port(), toy_body({{"milliseconds", 60'001}})));
  address_of(begin(server.port(), toy_body({{"milliseconds", 60'002}})));
  const auto refused = begin(server.port(), toy_body({{"milliseconds", 60'003}}));
  CHECK(refused->status == 503);
  CHECK(refused->code() == "busy");
  CHECK_FALSE(refused->header("retry-after").empty());
}

TEST_CASE("Events tell a job at once, as it changes, and how it ended, and agree with polling") {
  const Running server;
  const std::string address = address_of(begin(server.port(), slow_sweep(20, 100)));
  const auto events = get(server.port(), address + "/events");
  REQUIRE(events);
  CHECK(events->header("content-type") == "text/event-stream");
  const std::vector<Json> jobs = jobs_in(events->body);
  REQUIRE(jobs.size() > 2);
  double progress = 0;
  for (const Json& job : jobs) {
    CAPTURE(job.dump());
    CHECK(job["progress"] >= progress);
    progress = job["progress"];
  }
  CHECK(jobs.back() == get(server.port(), address)->json());
  CHECK(jobs.back()["state"] == "succeeded");
  CHECK(events->body.find("id: ended\n") != std::string::npos);
  CHECK(jobs_in(get(server.port(), address + "/events")->body) == std::vector<Json>{jobs.back()});
  CHECK(get(server.port(), address + "/events", "Last-Event-ID: ended\r\n")->status == 204);
  CHECK(get(server.port(), "/v1/jobs/none/events")->status == 404);
}

TEST_CASE("Who follows a job and leaves is forgotten, and the job goes on") {
  const Running server;
  const std::string address = address_of(begin(server.port(), toy_body({{"milliseconds", 400}})));
  for (int i = 0; i < 20; ++i) {
    Client client(server.port());
    client.send("GET " + address + "/events HTTP/1.1\r\nHost: localhost\r\n\r\n");
  }
  REQUIRE(reaches(server.port(), address, "succeeded"));
}

TEST_CASE("A server that ends lets its followers go, and the next one goes on with the jobs") {
  const Folder folder;
  std::string evaluation, sweep;
  const std::string short_evaluation = toy_body({{"bytes", 7}});
  std::string done;
  std::vector<Json> before;
  {
    auto server = std::make_unique<Running>(kept_in(folder));
    done = address_of(begin(server->port(), short_evaluation));
    REQUIRE(reaches(server->port(), done, "succeeded"));
    sweep = address_of(begin(server->port(), slow_sweep(20, 120)));
    evaluation = address_of(begin(server->port(), toy_body({{"bytes", 8}})));
    REQUIRE(eventually([&] { return get(server->port(), sweep)->json()["variants"]["done"] > 2; }));
    Client follower(server->port());
    follower.send("GET " + sweep + "/events HTTP/1.1\r\nHost: localhost\r\n\r\n");
    REQUIRE(follower.receive(true));
    server->stop();
    CHECK_FALSE(follower.rest().empty());
  }
  const Running server(kept_in(folder));
  CHECK(state_of(server.port(), done) == "succeeded");
  CHECK(get(server.port(), done + "/result")->body.size() == 7);
  REQUIRE(reaches(server.port(), sweep, "succeeded"));
  REQUIRE(reaches(server.port(), evaluation, "succeeded"));
  const std::vector<Json> lines = get(server.port(), sweep + "/result")->lines();
  REQUIRE(lines.size() == 120);
  for (std::size_t i = 0; i < lines.size(); ++i) CHECK(lines[i]["index"] == i);
  const std::string model = lines.front()["model"]["address"];
  CHECK(get(server.port(), model)->status == 200);
}

TEST_CASE("What came of a job is kept for its time") {
  auto settings = quick_settings();
  settings.job_result_time = std::chrono::milliseconds(1'500);
  const Running server(settings);
  const std::string address = address_of(begin(server.port(), toy_body({{"bytes", 9}})));
  REQUIRE(reaches(server.port(), address, "expired"));
  const auto gone = get(server.port(), address + "/result");
  CHECK(gone->status == 410);
  CHECK(gone->code() == "job-expired");
  REQUIRE(eventually([&] { return get(server.port(), address)->status == 404; }));
}

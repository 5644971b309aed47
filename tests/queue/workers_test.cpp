// Sweeps that workers compute, with real processes.

#include "tests/queue/workers.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

using namespace dini;
using support::Fleet;

namespace {

Json example_sweep() {
  std::ifstream file(std::string(DINI_EXAMPLES) + "/fig04_boosted_ring.json");
  Json graph = Json::parse(file);
  const std::string parameter = graph["parameters"].begin().key();
  const Json& told = graph["parameters"].begin().value();
  const double usual = told["default"].get<double>();
  return {{"graph", graph}, {"grid", {{parameter, {usual, usual * 0.9, usual * 0.8, usual * 0.7, 1e9}}}}};
}

/// The answer to a sweep, which comes on a thread of its own while the test does other things.
class Asked {
 public:
  Asked(int port, const Json& body, const std::string& path = "/v1/sweeps")
      : thread_([this, port, text = body.dump(), path] { answer_ = support::post(port, path, text); }) {}
  std::optional<support::Answer> answer() {
    if (thread_.joinable()) thread_.join();
    return answer_;
  }
  ~Asked() { answer(); }

 private:
  std::optional<support::Answer> answer_;
  std::thread thread_;
};

void check_complete(const std::optional<support::Answer>& answer, std::size_t count) {
  REQUIRE(answer);
  REQUIRE(answer->status == 200);
  const auto lines = answer->lines();
  REQUIRE(lines.size() == count);
  for (std::size_t i = 0; i < count; ++i) {
    CHECK(lines[i]["index"] == i);
    CHECK(lines[i]["status"] == "succeeded");
  }
}

}  // namespace

TEST_CASE("Workers answer a sweep with the bytes that a server alone answers it with") {
  const Json body = example_sweep();
  support::ServingProgram alone({}, DINI_PROGRAM);
  Fleet fleet(DINI_PROGRAM, 2);
  const auto expected = support::post(alone.port(), "/v1/sweeps", body.dump());
  const auto answer = support::post(fleet.port(), "/v1/sweeps", body.dump());
  REQUIRE(expected);
  REQUIRE(answer);
  CHECK(answer->status == 200);
  CHECK(answer->body == expected->body);
  REQUIRE(answer->lines().size() == 5);
  CHECK(answer->lines().back()["status"] == "failed");
  CHECK(fleet.metric("dini_queue_lines_total") == 5);
  const std::string address = answer->lines().front()["model"]["address"];
  const auto expected_file = support::get(alone.port(), address);
  const auto file = support::get(fleet.port(), address);
  REQUIRE(file);
  CHECK(file->status == 200);
  CHECK(file->body == expected_file->body);
}

TEST_CASE("Workers are given the mesh files that a graph names") {
  std::ifstream file(std::string(DINI_EXAMPLES) + "/fig12_imported_mesh.json");
  const Json graph = Json::parse(file);
  const std::string text = graph.dump();
  support::ServingProgram alone({}, DINI_PROGRAM);
  Fleet fleet(DINI_PROGRAM, 1);
  for (const auto& asset : std::filesystem::directory_iterator(std::string(DINI_EXAMPLES) + "/assets")) {
    std::ifstream bytes(asset.path(), std::ios::binary);
    const std::string body{std::istreambuf_iterator<char>(bytes), {}};
    for (const int port : {alone.port(), fleet.port()}) {
      support::ask(port,
                   "POST /v1/assets HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/octet-stream\r\n"
                   "Content-Length: " +
                       std::to_string(body.size()) + "\r\n\r\n" + body);
    }
  }
  const Json body = {{"graph", graph}, {"list", Json::array({Json::object()})}};
  const auto expected = support::post(alone.port(), "/v1/sweeps", body.dump());
  const auto answer = support::post(fleet.port(), "/v1/sweeps", body.dump());
  REQUIRE(answer);
  CHECK(answer->lines().at(0)["status"] == "succeeded");
  CHECK(answer->body == expected->body);
}

TEST_CASE("A job is computed by workers, also one that waited for them") {
  Fleet fleet(support::toy_program, 0);
  const auto begun = support::post(fleet.port(), "/v1/jobs", support::toy_sweep(40, 1).dump());
  REQUIRE(begun);
  REQUIRE(begun->status == 202);
  const std::string address = begun->json()["address"];
  fleet.add_worker();
  CHECK(support::eventually([&] { return support::get(fleet.port(), address)->json()["state"] == "succeeded"; }));
  check_complete(support::get(fleet.port(), address + "/result"), 40);
}

TEST_CASE("Without a worker a sweep is refused at once, and told when to come again") {
  Fleet fleet(support::toy_program, 0);
  const auto answer = support::post(fleet.port(), "/v1/sweeps", support::toy_sweep(2, 1).dump());
  REQUIRE(answer);
  CHECK(answer->status == 503);
  CHECK(answer->code() == "queue-failed");
  CHECK_FALSE(answer->header("retry-after").empty());
}

TEST_CASE("A sweep is complete though a worker is killed and another one hangs") {
  Fleet fleet(support::toy_program, 3);
  Asked asked(fleet.port(), support::toy_sweep(300, 20));
  REQUIRE(support::eventually([&] { return fleet.metric("dini_queue_lines_total") > 20; }));
  fleet.workers().front().signal(SIGKILL);
  fleet.workers().back().signal(SIGSTOP);
  check_complete(asked.answer(), 300);
  CHECK(fleet.metric("dini_queue_again_total") >= 2);
  fleet.workers().back().signal(SIGCONT);
}

TEST_CASE("A variant that ends its workers is told as failed, and all others as they are") {
  Fleet fleet(support::toy_program, 5);
  Json body = support::toy_sweep(0, 1);
  body.erase("grid");
  for (int i = 0; i < 20; ++i) body["list"].push_back({{"reach", i}, {"fatal", i == 7 ? 1 : 0}});
  const auto answer = support::post(fleet.port(), "/v1/sweeps", body.dump());
  REQUIRE(answer);
  const auto lines = answer->lines();
  REQUIRE(lines.size() == 20);
  for (const Json& line : lines) CHECK(line["status"] == (line["index"] == 7 ? "failed" : "succeeded"));
  CHECK(lines[7]["errors"][0]["code"] == "poisoned-input");
  CHECK(lines[7]["parameters"]["reach"] == 7);
  CHECK(fleet.metric("dini_queue_dead") == 1);

  const auto told = support::Program({support::toy_program, "queue", "dead", "--queue", fleet.redis().url()}).wait();
  CHECK(told.code == 0);
  CHECK(told.out.find("variant 7 of sweep") != std::string::npos);
  const std::string entry = told.out.substr(0, told.out.find(' '));
  CHECK(support::Program({support::toy_program, "queue", "drop", entry, "--queue", fleet.redis().url()}).wait().code ==
        0);
  CHECK(support::Program({support::toy_program, "queue", "drop", entry, "--queue", fleet.redis().url()}).wait().code ==
        2);
  CHECK(support::Program({support::toy_program, "queue", "dead", "--queue", fleet.redis().url()}).wait().out.empty());
}

TEST_CASE("A client that leaves and a job that is canceled leave nothing to compute") {
  Fleet fleet(support::toy_program, 1);
  const auto begun = support::post(fleet.port(), "/v1/jobs", support::toy_sweep(1000, 20).dump());
  const std::string address = begun->json()["address"];
  {
    support::Client client(fleet.port());
    client.send(support::post_text("/v1/sweeps", support::toy_sweep(1000, 20).dump()));
    REQUIRE(support::eventually([&] { return fleet.metric("dini_queue_waiting_interactive") > 0; }));
  }
  support::post(fleet.port(), address + "/cancel", "");
  CHECK(support::eventually(
      [&] { return fleet.metric("dini_queue_waiting_interactive") + fleet.metric("dini_queue_waiting_batch") == 0; }));
  CHECK(support::get(fleet.port(), address)->json()["state"] == "canceled");
}

TEST_CASE("An answer comes whole that is larger than its client takes at once") {
  Fleet fleet(support::toy_program, 2);
  check_complete(support::post(fleet.port(), "/v1/sweeps", support::toy_sweep(6000, 0).dump()), 6000);
}

TEST_CASE("A damaged line is seen, counted and computed again") {
  Fleet fleet(support::toy_program, 1);
  const auto begun = support::post(fleet.port(), "/v1/jobs", support::toy_sweep(200, 10).dump());
  const std::string address = begun->json()["address"];
  // Between a worker and the server somebody writes into what lies there.
  const std::string damage =
      "local n = 0; for _, key in ipairs(redis.call('KEYS', 'dini:*:lines')) do "
      "for _, field in ipairs(redis.call('HKEYS', key)) do redis.call('HSET', key, field, 'broken'); n = n + 1 end "
      "end; "
      "return n";
  REQUIRE(support::eventually([&] { return fleet.redis().call({"EVAL", damage, "0"}).number > 0; }));
  CHECK(support::eventually([&] { return support::get(fleet.port(), address)->json()["state"] == "succeeded"; }));
  check_complete(support::get(fleet.port(), address + "/result"), 200);
  CHECK(fleet.metric("dini_queue_damaged_total") >= 1);
}

TEST_CASE("A worker tells Prometheus what it does") {
  Fleet fleet(support::toy_program, 0);
  const int port = support::free_port();
  fleet.add_worker({"--threads", "1", "--metrics", std::to_string(port)});
  REQUIRE(support::eventually([&] { return fleet.live_workers() == 1; }));
  check_complete(support::post(fleet.port(), "/v1/sweeps", support::toy_sweep(5, 1).dump()), 5);
  const auto has = [&](const std::string& line) {
    const auto answer = support::get(port, "/metrics");
    return answer && answer->status == 200 && answer->body.find("\n" + line + "\n") != std::string::npos;
  };
  CHECK(support::eventually([&] { return has("dini_worker_variants_total 5"); }));
  CHECK(support::eventually([&] { return has("dini_worker_running 0"); }));
  CHECK(has("dini_worker_in_vain_total 0"));
  CHECK(has("dini_build_info{version=\"0.0.0-toy\"} 1"));
}

TEST_CASE("A worker says why it cannot tell Prometheus anything") {
  support::RedisServer redis;
  const auto said = [&](const std::string& address) {
    return support::Program({support::toy_program, "worker", "--queue", redis.url(), "--metrics", address}).wait();
  };
  for (const char* wrong : {"", "here", "127.0.0.1:", "127.0.0.1:99999", "80a"}) {
    CAPTURE(wrong);
    const auto outcome = said(wrong);
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("--metrics takes PORT or HOST:PORT") != std::string::npos);
  }
  const auto taken = said(std::to_string(redis.port()));
  CHECK(taken.code == 75);
  CHECK(taken.err.find("cannot be listened at") != std::string::npos);
}

TEST_CASE("A worker ends by what it was told: 0 by a signal, 2 for what is wrong, 75 for what may pass") {
  support::RedisServer redis({"--requirepass", "right"});
  const std::string host = "127.0.0.1:" + std::to_string(redis.port());
  CHECK(support::Program({support::toy_program, "worker"}).wait().code == 2);
  CHECK(support::Program({support::toy_program, "worker", "--queue", "http://" + host}).wait().code == 2);
  const auto denied =
      support::Program({support::toy_program, "worker", "--queue", "redis://:wrong-one@" + host}).wait();
  CHECK(denied.code == 2);
  CHECK(denied.err.find("WRONGPASS") != std::string::npos);
  CHECK(denied.err.find("wrong-one") == std::string::npos);
  support::WorkingProgram worker(support::toy_program, "redis://:right@" + host);
  queue::Address address = redis.address();
  address.password = "right";
  queue::Connection connection(address, {});
  REQUIRE(support::eventually([&] {
    return connection.call({"EXISTS", "dini:link"}) && !connection.call({"KEYS", "dini:*:workers"})->list.empty();
  }));
  worker.signal(SIGTERM);
  CHECK(worker.wait().code == 0);
  CHECK(connection.call({"KEYS", "dini:*:workers"})->list.empty());
  redis.end();
  CHECK(support::Program({support::toy_program, "worker", "--queue", "redis://:right@" + host}).wait().code == 75);
}

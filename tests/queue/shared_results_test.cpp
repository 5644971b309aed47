// Servers that share the models that they compute, with real processes and the real engine.

#include <thread>

#include "tests/queue/workers.h"

using namespace dini;

namespace {

/// Two servers of one Redis. What is asked of them takes some hundredths of a second to compute.
struct Pair {
  support::RedisServer redis;
  support::ServingProgram one{{"--queue", redis.url()}, DINI_PROGRAM};
  support::ServingProgram other{{"--queue", redis.url()}, DINI_PROGRAM};
};

std::string ball(double radius) {
  const Json graph = {
      {"format", 1},
      {"nodes",
       {{"ball", {{"type", "sphere_mesh"}, {"inputs", {{"radius", radius}, {"segments", 600}, {"rings", 300}}}}},
        {"out", {{"type", "export"}, {"inputs", {{"model", {{"from", "ball"}}}}}}}}}};
  return Json{{"graph", graph}}.dump();
}

double metric(const support::ServingProgram& server, const std::string& name) {
  const auto answer = support::get(server.port(), "/metrics");
  REQUIRE(answer);
  const auto place = answer->body.find("\n" + name + " ");
  return place == std::string::npos ? 0 : std::stod(answer->body.substr(place + name.size() + 2));
}

double exports(const support::ServingProgram& server) {
  return metric(server, "dini_node_runs_total{type=\"export\"}");
}

std::optional<support::Answer> evaluate(const support::ServingProgram& server, double radius) {
  return support::post(server.port(), "/v1/evaluate", ball(radius));
}

}  // namespace

TEST_CASE("A model that one server has computed is known to the other, with the same bytes, tag and report") {
  Pair pair;
  const auto computed = evaluate(pair.one, 1);
  const auto taken = evaluate(pair.other, 1);
  REQUIRE(computed);
  REQUIRE(taken);
  CHECK(computed->status == 200);
  CHECK(taken->body == computed->body);
  CHECK(taken->header("etag") == computed->header("etag"));
  CHECK(exports(pair.one) == 1);
  CHECK(exports(pair.other) == 0);
  CHECK(metric(pair.other, "dini_shared_hits_total") == 1);
  const auto report = [](const support::ServingProgram& server) {
    return support::post(server.port(), "/v1/evaluate", ball(1), "Accept: application/json\r\n")->json();
  };
  const Json here = report(pair.one), there = report(pair.other);
  for (const char* const member : {"model", "warnings", "checks", "output", "fingerprint", "etag"}) {
    CAPTURE(member);
    CHECK(there[member] == here[member]);
  }
}

TEST_CASE("A hundred equal requests at two servers at once are computed once, or twice at most") {
  Pair pair;
  std::vector<std::thread> askers;
  std::atomic<int> well = 0;
  for (int i = 0; i < 100; ++i) {
    askers.emplace_back([&, i] {
      const auto answer = evaluate(i % 2 == 0 ? pair.one : pair.other, 2);
      well += answer && answer->status == 200 ? 1 : 0;
    });
  }
  for (std::thread& asker : askers) asker.join();
  CHECK(well == 100);
  const double computed = exports(pair.one) + exports(pair.other);
  CHECK(computed >= 1);
  CHECK(computed <= 2);
}

TEST_CASE("A damaged, a cut and a foreign result are computed again, and counted") {
  Pair pair;
  const auto computed = evaluate(pair.one, 3);
  REQUIRE(computed->status == 200);
  const auto keys = pair.redis.call({"KEYS", "dini:result:*"});
  REQUIRE(keys.list.size() == 1);
  const std::string key = keys.list.front().text;
  const std::string value = pair.redis.call({"GET", key}).text;
  std::string flipped = value, foreign = value;
  flipped.back() = static_cast<char>(flipped.back() ^ 1);
  foreign.replace(foreign.find(' ', 5) + 1, 1, "9");  // another version of the engine
  for (const std::string& wrong : {flipped, value.substr(0, value.size() / 2), foreign}) {
    pair.redis.call({"SET", key, wrong});
    support::ServingProgram fresh({"--queue", pair.redis.url()}, DINI_PROGRAM);
    const auto again = evaluate(fresh, 3);
    REQUIRE(again);
    CHECK(again->body == computed->body);
    CHECK(exports(fresh) == 1);
    CHECK(metric(fresh, "dini_shared_damaged_total") == 1);
    CHECK(pair.redis.call({"GET", key}).text == value);
  }
}

TEST_CASE("A server whose Redis hangs computes by itself") {
  Pair pair;
  REQUIRE(evaluate(pair.one, 4)->status == 200);
  pair.redis.signal(SIGSTOP);
  const auto answer = evaluate(pair.one, 5);
  REQUIRE(answer);
  CHECK(answer->status == 200);
  CHECK(exports(pair.one) == 2);
  pair.redis.signal(SIGCONT);
}

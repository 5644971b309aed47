// A Redis that hangs, goes, is full, forgets everything or takes no password: what somebody waits for goes on, sweeps
// are refused or go on later, and all is well again without a restart of anything.

#include <thread>

#include "tests/queue/workers.h"

using namespace dini;
using support::Fleet;

namespace {

std::optional<support::Answer> evaluate(const Fleet& fleet) {
  static int count = 0;
  return support::post(fleet.port(), "/v1/evaluate", support::toy_body({{"bytes", 1000 + ++count}}));
}

std::optional<support::Answer> sweep(const Fleet& fleet) {
  return support::post(fleet.port(), "/v1/sweeps", support::toy_sweep(3, 1).dump());
}

void check_trouble(const Fleet& fleet) {
  REQUIRE(support::eventually([&] { return !fleet.is_whole(); }));
  const auto ready = support::get(fleet.port(), "/readyz");
  CHECK(ready->status == 200);
  CHECK(ready->json()["degraded"] == Json{"queue"});
  CHECK(evaluate(fleet)->status == 200);
  const auto refused = sweep(fleet);
  REQUIRE(refused);
  CHECK(refused->status == 503);
  CHECK(refused->code() == "queue-failed");
  CHECK_FALSE(refused->header("retry-after").empty());
  CHECK(fleet.metric("dini_queue_up") == 0);
}

void check_recovery(const Fleet& fleet) {
  CHECK(support::eventually([&] { return fleet.is_whole(); }));
  CHECK(support::eventually([&] {
    const auto answer = sweep(fleet);
    return answer && answer->status == 200 && answer->lines().size() == 3;
  }));
}

}  // namespace

TEST_CASE("A server goes on while Redis hangs") {
  Fleet fleet(support::toy_program, 1);
  fleet.redis().signal(SIGSTOP);
  CHECK(evaluate(fleet)->status == 200);
  check_trouble(fleet);
  fleet.redis().signal(SIGCONT);
  check_recovery(fleet);
}

TEST_CASE("A server goes on while Redis is gone, and when it comes back empty") {
  Fleet fleet(support::toy_program, 1);
  fleet.redis().end();
  check_trouble(fleet);
  fleet.redis().start();
  check_recovery(fleet);
}

TEST_CASE("A server goes on while Redis has no memory") {
  Fleet fleet(support::toy_program, 1);
  fleet.redis().call({"CONFIG", "SET", "maxmemory", "1"});
  check_trouble(fleet);
  fleet.redis().call({"CONFIG", "SET", "maxmemory", "0"});
  check_recovery(fleet);
}

TEST_CASE("A server goes on while Redis does not take its password") {
  Fleet fleet(support::toy_program, 1);
  fleet.redis().call({"CONFIG", "SET", "requirepass", "another"});
  queue::Address address = fleet.redis().address();
  address.password = "another";
  queue::Connection owner(address, {});
  REQUIRE(owner.call({"CLIENT", "KILL", "TYPE", "normal"}));
  check_trouble(fleet);
  REQUIRE(owner.call({"CONFIG", "SET", "requirepass", ""}));
  check_recovery(fleet);
}

TEST_CASE("A server starts without its Redis, and finds it later") {
  support::RedisServer redis;
  redis.end();
  support::ServingProgram serving({"--queue", redis.url()}, support::toy_program);
  CHECK(support::get(serving.port(), "/readyz")->json()["degraded"] == Json{"queue"});
  redis.start();
  CHECK(support::eventually([&] { return !support::get(serving.port(), "/readyz")->json().contains("degraded"); }));
}

TEST_CASE("A job goes on after all connections were cut and after Redis began anew without anything") {
  Fleet fleet(support::toy_program, 2);
  const auto begun = support::post(fleet.port(), "/v1/jobs", support::toy_sweep(300, 10).dump());
  REQUIRE(begun->status == 202);
  const std::string address = begun->json()["address"];
  const auto done = [&] { return support::get(fleet.port(), address)->json()["variants"]["done"].get<int>(); };
  REQUIRE(support::eventually([&] { return done() > 10; }));
  fleet.redis().call({"CLIENT", "KILL", "TYPE", "normal"});
  const int before = done();
  REQUIRE(support::eventually([&] { return done() > before + 10; }));
  fleet.redis().end();
  fleet.redis().start();
  CHECK(support::eventually([&] { return support::get(fleet.port(), address)->json()["state"] == "succeeded"; }));
  const auto result = support::get(fleet.port(), address + "/result");
  REQUIRE(result->lines().size() == 300);
  for (std::size_t i = 0; i < 300; ++i) CHECK(result->lines()[i]["index"] == i);
  CHECK(fleet.metric("dini_queue_sweeps_total") >= 2);
}

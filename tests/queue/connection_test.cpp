#include "queue/connection.h"

#include "queue/link.h"
#include "tests/support/redis_server.h"

using namespace dini;
using queue::Fault;

TEST_CASE("A connection answers, and says why it does not") {
  support::RedisServer redis;
  queue::Connection connection(redis.address(), {});
  REQUIRE(connection.call({"SET", "key", std::string("a\0b", 3)}));
  CHECK(connection.call({"GET", "key"})->text == std::string("a\0b", 3));
  CHECK(connection.call({"GET", "nothing"})->empty());
  CHECK(connection.call({"INCR", "number"})->number == 1);
  const auto wrong = connection.call({"INCR", "key"});
  REQUIRE_FALSE(wrong);
  CHECK(wrong.error().kind == Fault::Kind::refused);
  CHECK(connection.is_connected());
}

TEST_CASE("A script that Redis does not know is sent, and known from then on, also after Redis began anew") {
  support::RedisServer redis;
  queue::Connection connection(redis.address(), {});
  const queue::Script script("return {KEYS[1], ARGV[1]}");
  for (int time = 0; time < 2; ++time) {
    const auto answered = connection.run(script, {"k"}, {"a"});
    REQUIRE(answered);
    CHECK(answered->list.at(1).text == "a");
    redis.call({"SCRIPT", "FLUSH"});
  }
}

TEST_CASE("A connection that was lost is made again by the next call") {
  support::RedisServer redis;
  queue::Connection connection(redis.address(), {});
  REQUIRE(connection.call({"PING"}));
  redis.call({"CLIENT", "KILL", "TYPE", "normal"});
  const auto lost = connection.call({"PING"});
  REQUIRE_FALSE(lost);
  CHECK(lost.error().kind == Fault::Kind::lost);
  CHECK(connection.call({"PING"}));

  redis.end();
  CHECK_FALSE(connection.call({"PING"}));
  CHECK(connection.call({"PING"}).error().kind == Fault::Kind::lost);
  redis.start();
  CHECK(connection.call({"PING"}));
}

TEST_CASE("A Redis that hangs is given up") {
  support::RedisServer redis;
  queue::Connection connection(redis.address(), {});
  REQUIRE(connection.call({"PING"}));
  redis.signal(SIGSTOP);
  const auto hung = connection.call({"PING"});
  redis.signal(SIGCONT);
  REQUIRE_FALSE(hung);
  CHECK(hung.error().kind == Fault::Kind::lost);
}

TEST_CASE("A wrong password is told from a Redis that is away, and is never repeated") {
  support::RedisServer redis({"--requirepass", "right"});
  queue::Address address = redis.address();
  const auto without = queue::Connection(address, {}).call({"PING"});
  REQUIRE_FALSE(without);
  CHECK(without.error().kind == Fault::Kind::denied);
  address.password = "wrong-one";
  const auto wrong = queue::Connection(address, {}).call({"PING"});
  REQUIRE_FALSE(wrong);
  CHECK(wrong.error().kind == Fault::Kind::denied);
  CHECK(wrong.error().detail.find("wrong-one") == std::string::npos);
  address.password = "right";
  CHECK(queue::Connection(address, {}).call({"PING"}));
}

TEST_CASE("A link notices that Redis goes, is full, and comes back") {
  support::RedisServer redis;
  queue::Link link(redis.address());
  CHECK(link.is_well());
  redis.call({"CONFIG", "SET", "maxmemory", "1"});
  CHECK(support::eventually([&] { return !link.is_well(); }));
  CHECK(link.trouble().find("memory") != std::string::npos);
  redis.call({"CONFIG", "SET", "maxmemory", "0"});
  CHECK(support::eventually([&] { return link.is_well(); }));
  redis.end();
  CHECK(support::eventually([&] { return !link.is_well(); }));
  redis.start();
  CHECK(support::eventually([&] { return link.is_well(); }));
}

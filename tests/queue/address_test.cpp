#include "queue/address.h"

#include <catch2/catch.hpp>

using namespace dini;

TEST_CASE("An address of a queue tells host, port, database and login") {
  const auto plain = queue::read_address("redis://cache");
  REQUIRE(plain);
  CHECK(plain->host == "cache");
  CHECK(plain->port == 6379);
  CHECK(plain->database == 0);
  CHECK(plain->password.empty());

  const auto full = queue::read_address("redis://dini:a%40b%3ac@10.0.0.5:7000/3");
  REQUIRE(full);
  CHECK(full->host == "10.0.0.5");
  CHECK(full->port == 7000);
  CHECK(full->database == 3);
  CHECK(full->user == "dini");
  CHECK(full->password == "a@b:c");

  const auto six = queue::read_address("redis://:secret@[::1]:7000");
  REQUIRE(six);
  CHECK(six->host == "::1");
  CHECK(six->user.empty());
}

TEST_CASE("What is no address of a queue is refused without telling the password") {
  for (const std::string text : {"", "localhost:6379", "http://cache", "redis://", "redis://:secret@", "redis://a:0",
                                 "redis://a:70000", "redis://a:x", "redis://a/b", "redis://secret@a", "redis://:@a"}) {
    CAPTURE(text);
    const auto read = queue::read_address(text);
    REQUIRE_FALSE(read);
    CHECK(read.problems().front().code == "usage");
    CHECK(read.problems().front().detail.find("secret") == std::string::npos);
  }
  CHECK(queue::Address{.password = "secret"}.text().find("secret") == std::string::npos);
}

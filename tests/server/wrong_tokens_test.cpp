// What becomes of tokens that are wrong.

#include "server/wrong_tokens.h"

#include "tests/server/fixture.h"

using namespace dini;
using namespace dini::support;
using server::Address;
using server::WrongTokens;

namespace {

using Clock = WrongTokens::Clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

const Clock::time_point begin{};

server::Settings guarded(std::size_t wrong_tokens) {
  auto settings = quick_settings();
  settings.token = "swordfish";
  settings.wrong_tokens = wrong_tokens;
  return settings;
}

std::string bearing(const std::string& token) { return "Authorization: Bearer " + token + "\r\n"; }

std::optional<Answer> ask_with(int port, const std::string& token, const std::string& headers = "") {
  return get(port, "/v1/nodes", bearing(token) + headers);
}

}  // namespace

TEST_CASE("Some wrong tokens may come at once, and as many again in every minute") {
  WrongTokens wrong(3);
  const auto one = Address::parse("10.0.0.1");
  for (int i = 0; i < 3; ++i) CHECK_FALSE(wrong.count(one, begin));
  CHECK(wrong.count(one, begin) == seconds(20));
  CHECK(wrong.count(one, begin + seconds(15)) == seconds(5));
  CHECK_FALSE(wrong.count(one, begin + seconds(20)));
  CHECK(wrong.count(one, begin + seconds(20)) == seconds(20));
  CHECK(wrong.total() == 7);
  // However long nothing came, it is never more than at first.
  for (int i = 0; i < 3; ++i) CHECK_FALSE(wrong.count(one, begin + std::chrono::hours(9)));
  CHECK(wrong.count(one, begin + std::chrono::hours(9)));
}

TEST_CASE("Whoever has another address is not held to account, whoever has many of one network is") {
  WrongTokens wrong(1);
  const auto is_refused = [&](const char* address) { return wrong.count(Address::parse(address), begin).has_value(); };
  CHECK_FALSE(is_refused("10.0.0.1"));
  CHECK(is_refused("10.0.0.1"));
  CHECK(is_refused("::ffff:10.0.0.1"));
  CHECK_FALSE(is_refused("10.0.0.2"));
  CHECK_FALSE(is_refused("2001:db8:1:2::1"));
  CHECK(is_refused("2001:db8:1:2:ffff::7"));
  CHECK_FALSE(is_refused("2001:db8:1:3::1"));
}

TEST_CASE("Those who were wrong longest ago are forgotten when there are too many") {
  WrongTokens wrong(1);
  const auto numbered = [](std::size_t i) {
    return Address::parse("10." + std::to_string(i / 65536) + "." + std::to_string(i / 256 % 256) + "." +
                          std::to_string(i % 256));
  };
  wrong.count(numbered(0), begin);
  wrong.count(numbered(1), begin);
  for (std::size_t i = 2; i < 20'000; ++i) {
    wrong.count(numbered(i), begin);
    CHECK(wrong.count(numbered(0), begin));  // it stays, being wrong all the time
  }
  CHECK(wrong.senders() == WrongTokens::most_senders);
  CHECK_FALSE(wrong.count(numbered(1), begin));
}

TEST_CASE("After too many wrong tokens further ones are told to wait, and the right one is taken") {
  const Running server(guarded(2));
  CHECK(ask_with(server.port(), "a")->status == 401);
  CHECK(ask_with(server.port(), "b")->status == 401);
  const auto refused = ask_with(server.port(), "c");
  REQUIRE(refused->status == 429);
  CHECK(refused->code() == "too-many-wrong-tokens");
  const int wait = std::stoi(refused->header("retry-after"));
  CHECK(wait > 0);
  CHECK(wait <= 30);
  CHECK(refused->header("www-authenticate").empty());
  CHECK(ask_with(server.port(), "swordfish")->status == 200);
  CHECK(ask_with(server.port(), "swordfish2")->status == 429);
  // Who has no token guesses nothing.
  for (int i = 0; i < 5; ++i) CHECK(get(server.port(), "/v1/nodes")->status == 401);
  CHECK(get(server.port(), "/healthz", bearing("d"))->status == 200);
  const std::string metrics = get(server.port(), "/metrics", bearing("swordfish"))->body;
  CHECK(metrics.find("dini_wrong_tokens_total 4\n") != std::string::npos);
  CHECK(metrics.find(R"(dini_requests_total{method="GET",route="/v1/nodes",status="429"} 2)") != std::string::npos);
}

TEST_CASE("Behind a trusted proxy each client answers for its own tokens, and nobody names another") {
  auto settings = guarded(1);
  settings.trusted_proxies = {*server::Network::parse("127.0.0.1")};
  const auto from = [](const std::string& client) { return "X-Forwarded-For: " + client + "\r\n"; };
  {
    const Running server(settings);
    CHECK(ask_with(server.port(), "a", from("10.0.0.1"))->status == 401);
    CHECK(ask_with(server.port(), "a", from("10.0.0.1"))->status == 429);
    CHECK(ask_with(server.port(), "a", from("10.0.0.2"))->status == 401);
    CHECK(ask_with(server.port(), "a", from("10.0.0.3, 10.0.0.1"))->status == 429);
  }
  settings.trusted_proxies.clear();
  const Running server(settings);
  CHECK(ask_with(server.port(), "a", from("10.0.0.1"))->status == 401);
  CHECK(ask_with(server.port(), "a", from("10.0.0.2"))->status == 429);
}

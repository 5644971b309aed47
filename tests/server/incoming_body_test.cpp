#include "server/incoming_body.h"

#include <catch2/catch.hpp>
#include <random>

#include "tests/server/fixture.h"

using namespace dini;
using namespace dini::support;
using server::IncomingBody;

namespace {

constexpr std::size_t limit = 1000;

/// What is wrong with a body in chunks; "" when it is whole, "more" when it is not yet.
std::string verdict(std::string_view bytes) {
  IncomingBody body = IncomingBody::in_chunks(limit);
  const auto taken = body.take(bytes);
  if (!taken) return taken.problems().front().code;
  return body.is_complete() ? "" : "more";
}

std::string chunk(std::string_view bytes, std::string_view extension = "") {
  std::array<char, 32> size{};
  std::snprintf(size.data(), size.size(), "%zx", bytes.size());
  return size.data() + std::string(extension) + "\r\n" + std::string(bytes) + "\r\n";
}

std::string evaluate_in_chunks(const std::string& body, const std::string& headers = "") {
  return "POST /v1/evaluate HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n" + headers +
         "Transfer-Encoding: chunked\r\n\r\n" + body;
}

}  // namespace

TEST_CASE("A body of a length takes so many bytes and no more") {
  IncomingBody body = IncomingBody::of_length(5);
  CHECK(*body.take("abc") == 3);
  CHECK_FALSE(body.is_complete());
  CHECK(*body.take("defg") == 2);
  CHECK(body.is_complete());
  CHECK(std::move(body).release() == "abcde");
  CHECK(IncomingBody::of_length(0).is_complete());
}

TEST_CASE("Chunks are read in one way only, or refused") {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"0\r\n\r\n", ""},
      {chunk("hello") + "0\r\n\r\n", ""},
      {chunk("hello", ";name=\"value\"") + "0;last\r\n\r\n", ""},
      {"00005\r\nhello\r\n0\r\n\r\n", ""},
      {"A\r\n0123456789\r\n0\r\nTrailer: passed over\r\n\r\n", ""},
      {"5", "more"},
      {"5\r\nhel", "more"},
      {"0\r\n", "more"},
      {"\r\n", "bad-request"},
      {" 5\r\n", "bad-request"},
      {"5 \r\n", "bad-request"},
      {"+5\r\n", "bad-request"},
      {"-5\r\n", "bad-request"},
      {"0x5\r\n", "bad-request"},
      {"5\n", "bad-request"},
      {"5\r\rn", "more"},
      {"5\r\r\n", "bad-request"},
      {"5;\x01\r\n", "bad-request"},
      {"000000005\r\n", "bad-request"},
      {"ffffffffffffffff5\r\n", "bad-request"},
      {"5\r\nhello5\r\n", "bad-request"},
      {"5\r\nhello\n", "bad-request"},
      {"0\r\nTrailer\n", "bad-request"},
      {"3e9\r\n", "body-too-large"},
      {chunk(std::string(999, 'x')) + "2\r\n", "body-too-large"},
      {chunk(std::string(1000, 'x')) + "0\r\n\r\n", ""},
      {std::string(300, '5'), "bad-request"},
      {"0\r\n" + std::string(300, 'x'), "bad-request"},
  };
  for (const auto& [bytes, code] : table) {
    CAPTURE(bytes);
    CHECK(verdict(bytes) == code);
  }
  std::string trailers = "0\r\n";
  for (int i = 0; i < 1000; ++i) trailers += "X: y\r\n";
  CHECK(verdict(trailers) == "bad-request");
}

TEST_CASE("A body in chunks is the same however it is cut, and ends where it ends") {
  std::mt19937 random(11);
  for (int round = 0; round < 200; ++round) {
    std::string whole, sent;
    for (std::size_t left = random() % 5; left > 0; --left) {
      std::string piece(1 + random() % 60, '\0');
      for (char& c : piece) c = static_cast<char>(random());
      whole += piece;
      sent += chunk(piece);
    }
    sent += "0\r\n\r\n";
    const std::size_t end = sent.size();
    sent += "GET / HTTP/1.1\r\n";
    IncomingBody body = IncomingBody::in_chunks(limit);
    std::size_t taken = 0;
    while (!body.is_complete()) {
      const std::size_t size = std::min<std::size_t>(1 + random() % 9, sent.size() - taken);
      const auto step = body.take(std::string_view(sent).substr(taken, size));
      REQUIRE(step);
      taken += *step;
      CHECK((*step == size || body.is_complete()));
    }
    CHECK(taken == end);
    CHECK(std::move(body).release() == whole);
  }
}

TEST_CASE("A request whose body comes in chunks is answered as one with a length") {
  const Running server;
  const std::string body = toy_body({{"bytes", 3000}});
  const auto expected = post(server.port(), "/v1/evaluate", body);
  Client client(server.port());
  for (int i = 0; i < 2; ++i) {  // the connection goes on
    client.send(evaluate_in_chunks(chunk(body.substr(0, 7))));
    client.send(chunk(body.substr(7), ";ignored"));
    client.send("0\r\nTrailer: ignored\r\n\r\n");
    const auto answer = client.receive();
    REQUIRE(answer);
    CHECK(answer->status == 200);
    CHECK(answer->body == expected->body);
  }
  client.send(evaluate_in_chunks("", "Expect: 100-continue\r\n"));
  const auto go_on = client.receive(true);
  REQUIRE(go_on);
  CHECK(go_on->status == 100);
  client.send(chunk(body) + "0\r\n\r\n");
  CHECK(client.receive()->status == 200);
}

TEST_CASE("A body in chunks that never ends is given up in time") {
  const Running server;
  Client client(server.port());
  client.send(evaluate_in_chunks("5\r\nhel"));
  const auto answer = client.receive();
  REQUIRE(answer);
  CHECK(answer->status == 408);
  CHECK(client.closed());
}

TEST_CASE("A body in chunks at an address that takes none is refused, an empty one is not") {
  const Running server;
  const std::string cancel =
      "POST /v1/jobs/none/cancel HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n";
  CHECK(ask(server.port(), cancel + chunk("hello"))->status == 413);
  CHECK(ask(server.port(), cancel + "0\r\n\r\n")->status == 404);
}

// What the guard does with those who do not play by the rules: raw bytes on real sockets.

#include <random>
#include <vector>

#include "tests/server/fixture.h"

namespace {

using namespace dini::testing;

constexpr std::size_t megabyte = 1 << 20;
constexpr long memory_slack_kib = 8 * 1024;  // of an allocator that keeps what it freed; the attacks send far more

const std::string host = "Host: localhost\r\n";

}  // namespace

TEST_CASE("Slow headers are cut at the deadline and hold nobody up") {
  const Running server;
  std::vector<std::unique_ptr<Client>> slow;
  for (int i = 0; i < 100; ++i) {
    slow.push_back(std::make_unique<Client>(server.port()));
    slow.back()->send("GET / HTTP/1.1\r\nX: ");
  }
  REQUIRE(get(server.port(), "/healthz"));
  for (const auto& client : slow) {
    const auto answer = client->receive();
    REQUIRE(answer);
    CHECK(answer->status == 408);
    CHECK(client->closed());
  }
}

TEST_CASE("A body that does not arrive is given up on") {
  const Running server;
  Client client(server.port());
  client.send("POST /v1/evaluate HTTP/1.1\r\n" + host + "Content-Length: 10\r\n\r\nabc");
  const auto answer = client.receive();
  REQUIRE(answer);
  CHECK(answer->status == 408);
  CHECK(client.closed());
}

TEST_CASE("A body over the limit is refused without being read") {
  const Running server;
  Client client(server.port());
  client.send("POST /v1/evaluate HTTP/1.1\r\n" + host + "Content-Length: 1048577\r\n\r\nx");
  const auto answer = client.receive();
  REQUIRE(answer);
  CHECK(answer->status == 413);
  CHECK(answer->header("connection") == "close");
  CHECK(client.closed());
}

TEST_CASE("Bodies without a length, and chunks of any size, are refused") {
  const Running server;
  const long before = resident_kib();
  for (const auto* chunk :
       {"5\r\nhello\r\n0\r\n\r\n", "-2\r\n", "-1\r\n", "zz\r\n", "0x10\r\n", "ffffffffffffffff\r\n"}) {
    Client client(server.port());
    client.send("POST /v1/evaluate HTTP/1.1\r\n" + host + "Transfer-Encoding: chunked\r\n\r\n" + chunk);
    const auto answer = client.receive();
    REQUIRE(answer);
    CHECK(answer->status == 411);
    CHECK(client.closed());
  }
  Client endless(server.port());
  endless.send("POST /v1/evaluate HTTP/1.1\r\n" + host + "\r\n");
  endless.flood(std::string(megabyte, 'x'), 64 * megabyte);
  const auto answer = endless.receive();
  REQUIRE(answer);
  CHECK(answer->status == 411);
  CHECK(resident_kib() - before < memory_slack_kib);
}

TEST_CASE("Endless headers and addresses cost no memory") {
  const Running server;
  const long before = resident_kib();
  const std::string start = "GET / HTTP/1.1\r\n" + host;
  const auto flood = [&](const std::string& opening, const std::string& piece) {
    Client client(server.port());
    client.send(opening);
    client.flood(piece, 100 * megabyte);
    const auto answer = client.receive();
    return answer ? answer->status : 0;
  };
  CHECK(flood(start + "X: ", std::string(megabyte, 'a')) == 431);
  std::string headers;
  for (int i = 0; i < 10'000; ++i) headers += "A: b\r\n";
  CHECK(flood(start, headers) == 431);
  CHECK(flood("GET /", std::string(megabyte, 'a')) == 414);
  CHECK(resident_kib() - before < memory_slack_kib);
}

TEST_CASE("A second request inside a body is never answered") {
  const Running server;
  const std::string inner = "GET /version HTTP/1.1\r\n" + host + "\r\n";
  const std::string length = "Content-Length: " + std::to_string(inner.size()) + "\r\n";
  for (const std::string outer : {"GET /healthz", "HEAD /healthz", "GET /nowhere", "GET /", "OPTIONS /v1/nodes"}) {
    CAPTURE(outer);
    Client client(server.port());
    client.send(outer + " HTTP/1.1\r\n" + host + length + "\r\n");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    client.send(inner);
    const auto answer = client.receive();
    REQUIRE(answer);
    CHECK(answer->status == 400);
    CHECK(client.closed());
  }
  Client client(server.port());
  client.send("POST /nowhere HTTP/1.1\r\n" + host + length + "\r\n" + inner);
  const auto answer = client.receive();
  REQUIRE(answer);
  CHECK(answer->status == 404);
  client.send("GET /healthz HTTP/1.1\r\n" + host + "\r\n");
  const auto second = client.receive();
  REQUIRE(second);
  CHECK(second->body == R"({"status":"ok"})");
}

TEST_CASE("Pipelined requests get one answer and a closed connection") {
  const Running server;
  Client client(server.port());
  std::string requests;
  for (int i = 0; i < 100; ++i) requests += "GET /healthz HTTP/1.1\r\n" + host + "\r\n";
  client.send(requests);
  const auto answer = client.receive();
  REQUIRE(answer);
  CHECK(answer->status == 200);
  CHECK(answer->header("connection") == "close");
  CHECK(client.closed());
}

TEST_CASE("A connection carries many requests one after the other") {
  const Running server;
  Client client(server.port());
  for (int i = 0; i < 50; ++i) {
    client.send("GET /healthz HTTP/1.1\r\n" + host + "\r\n");
    const auto answer = client.receive();
    REQUIRE(answer);
    CHECK(answer->status == 200);
  }
}

TEST_CASE("Compressed request bodies are not unpacked") {
  const Running server;
  for (const std::string encoding : {"gzip", "br", "deflate"}) {
    const auto answer = ask(server.port(), post_text("/v1/evaluate", "{}", "Content-Encoding: " + encoding + "\r\n"));
    REQUIRE(answer);
    CHECK(answer->status == 415);
  }
}

TEST_CASE("Ranges are ignored, however many") {
  const Running server;
  const long before = resident_kib();
  for (const int count : {1, 400, 1000}) {
    std::string ranges = "Range: bytes=0-1";
    for (int i = 1; i < count; ++i) ranges += ",0-1";
    const auto answer = get(server.port(), "/v1/nodes", ranges + "\r\n");
    REQUIRE(answer);
    CHECK(answer->status == 200);
    CHECK(answer->json().is_object());
  }
  CHECK(resident_kib() - before < memory_slack_kib);
}

TEST_CASE("Hidden line ends are refused and cannot forge a line of the log") {
  Running server;
  CHECK(get(server.port(), "/a%0d%0ab")->status == 400);
  CHECK(get(server.port(), "/a%00b")->status == 400);
  CHECK(get(server.port(), "/?a=%0a")->status == 400);
  CHECK(get(server.port(), "/", "X: a%0d%0ab: c\r\n")->status == 400);
  CHECK(ask(server.port(), "GET /\x1b[31mred HTTP/1.1\r\n" + host + "\r\n")->status == 400);
  CHECK(ask(server.port(), "GET /\nforged HTTP/1.1\r\n" + host + "\r\n")->status == 400);
  server.stop();
  CHECK(server.log().find('\x1b') == std::string::npos);
  CHECK(server.log().find("\nforged") == std::string::npos);
  CHECK(server.log().find("\\x1b[31mred") != std::string::npos);
}

TEST_CASE("Claimed addresses are not believed") {
  Running server;
  CHECK(get(server.port(), "/healthz", "REMOTE_ADDR: 6.6.6.6\r\nX-Forwarded-For: 6.6.6.6\r\n")->status == 200);
  server.stop();
  CHECK(server.log().find("6.6.6.6") == std::string::npos);
}

TEST_CASE("Long paths are answered on every kind of address") {
  const Running server;
  const std::string frame = "GET  HTTP/1.1\r\n";
  for (const std::string start : {"/", "/v1/examples/", "/v1/nodes/", "/healthz/"}) {
    const std::size_t longest = 8192 - frame.size() - start.size();
    for (const auto& [length, status] : {std::pair(longest, 404), std::pair(longest + 1, 414)}) {
      const auto answer = get(server.port(), start + std::string(length, 'a'));
      REQUIRE(answer);
      CHECK(answer->status == status);
      CHECK(answer->header("content-type") == "application/problem+json");
    }
  }
}

TEST_CASE("Only JSON is taken as a body") {
  const Running server;
  for (const std::string type :
       {"multipart/form-data; boundary=x", "application/x-www-form-urlencoded", "text/plain"}) {
    const auto answer = ask(server.port(), "POST /v1/evaluate HTTP/1.1\r\n" + host + "Content-Type: " + type +
                                               "\r\nContent-Length: 2\r\n\r\n{}");
    REQUIRE(answer);
    CHECK(answer->status == 415);
  }
}

TEST_CASE("Other protocols and unknown methods end cleanly") {
  const Running server;
  const std::vector<std::pair<std::string, int>> table = {
      {"BREW / HTTP/1.1\r\n" + host + "\r\n", 405},
      {"GET /\r\n\r\n", 400},
      {"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", 505},
      {std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11), 400},
  };
  for (const auto& [bytes, status] : table) {
    Client client(server.port());
    client.send(bytes);
    const auto answer = client.receive();
    REQUIRE(answer);
    CHECK(answer->status == status);
    CHECK(answer->header("content-type") == "application/problem+json");
    CHECK(client.closed());
  }
}

TEST_CASE("Random bytes and damaged requests leave the server standing") {
  const Running server;
  std::mt19937 random(11);
  const std::string good = post_text("/v1/evaluate", toy_body({{"bytes", 4}}));
  for (int i = 0; i < 300; ++i) {
    std::string bytes = good;
    for (int change = 0; change < 4; ++change) bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
    Client client(server.port());
    client.send(bytes);
    client.close();
  }
  const auto answer = get(server.port(), "/healthz");
  REQUIRE(answer);
  CHECK(answer->status == 200);
}

TEST_CASE("A client that expects to be told so may send its body") {
  const Running server;
  Client client(server.port());
  client.send("POST /v1/validate HTTP/1.1\r\n" + host +
              "Content-Type: application/json\r\nExpect: 100-continue\r\nContent-Length: 22\r\n\r\n");
  const auto go_on = client.receive();
  REQUIRE(go_on);
  CHECK(go_on->status == 100);
  client.send(R"({"graph":{"nodes":{}}})");
  CHECK(client.receive()->status == 200);
}

TEST_CASE("Connections beyond threads and queue are told to come back") {
  auto settings = quick_settings();
  settings.connection_threads = 1;
  settings.waiting_connections = 1;
  settings.head_deadline = std::chrono::seconds(3);
  const Running server(settings);
  Client first(server.port());
  first.send("GET /healthz HTTP/1.1\r\n");  // holds the only thread
  std::vector<std::unique_ptr<Client>> others;
  for (int i = 0; i < 4; ++i) others.push_back(std::make_unique<Client>(server.port()));
  const auto refused = others.back()->receive();
  REQUIRE(refused);
  CHECK(refused->status == 503);
  CHECK(refused->header("retry-after") == "1");
  CHECK(refused->code() == "busy");
}

// What the guard does with those who do not play by the rules: raw bytes on real sockets.

#include <random>
#include <vector>

#include "server/answer_writer.h"
#include "tests/server/fixture.h"

using namespace dini;
using namespace dini::support;

namespace {

constexpr std::size_t megabyte = 1 << 20;
constexpr long memory_slack_kib = 8 * 1024;  // of an allocator that keeps what it freed; the attacks send far more

}  // namespace

TEST_CASE("A body over the limit is refused without being read") {
  const Running server;
  Client client(server.port());
  client.send("POST /v1/evaluate HTTP/1.1\r\n" + host_line + "Content-Length: 1048577\r\n\r\nx");
  const auto answer = client.receive();
  REQUIRE(answer);
  CHECK(answer->status == 413);
  CHECK(answer->header("connection") == "close");
  CHECK(client.closed());
}

TEST_CASE("Chunks that are none or too large are refused") {
  const Running server;
  for (const auto& [chunk, status] : std::vector<std::pair<std::string, int>>{{"-2\r\n", 400},
                                                                              {"-1\r\n", 400},
                                                                              {"zz\r\n", 400},
                                                                              {"0x10\r\n", 400},
                                                                              {"ffffffffffffffff\r\n", 400},
                                                                              {" 5\r\nhello\r\n", 400},
                                                                              {"5\nhello\r\n", 400},
                                                                              {"5\r\nhello!\r\n", 400},
                                                                              {"\r\n", 400},
                                                                              {";\r\n", 400},
                                                                              {"ffffffff\r\n", 413},
                                                                              {"100001\r\n", 413}}) {
    CAPTURE(chunk);
    Client client(server.port());
    client.send("POST /v1/evaluate HTTP/1.1\r\n" + host_line + "Transfer-Encoding: chunked\r\n\r\n" + chunk);
    const auto answer = client.receive();
    REQUIRE(answer);
    CHECK(answer->status == status);
    CHECK(client.closed());
  }
}

TEST_CASE("Bodies without a length, and chunks without an end, cost no memory") {
  const Running server;
  const long before = resident_kib();
  const std::string endless_line(megabyte, 'x');
  const auto flood = [&](const std::string& opening, const std::string& piece) {
    Client client(server.port());
    client.send("POST /v1/evaluate HTTP/1.1\r\n" + host_line + "Transfer-Encoding: chunked\r\n\r\n" + opening);
    client.flood(piece, 64 * megabyte);
    const auto answer = client.receive();
    return answer ? answer->status : 0;
  };
  CHECK(flood("5;", endless_line) == 400);
  CHECK(flood("ffffffff\r\n", endless_line) == 413);
  CHECK(flood("0\r\n", "Trailer: of a body\r\n") == 400);
  Client endless(server.port());
  endless.send("POST /v1/evaluate HTTP/1.1\r\n" + host_line + "\r\n");
  endless.flood(endless_line, 64 * megabyte);
  const auto answer = endless.receive();
  REQUIRE(answer);
  CHECK(answer->status == 411);
  CHECK(resident_kib() - before < memory_slack_kib);
  // This one is kept until it is longer than a body may be.
  CHECK(flood("", "8000\r\n" + std::string(0x8000, ' ') + "\r\n") == 413);
}

TEST_CASE("Endless headers and addresses cost no memory") {
  const Running server;
  const long before = resident_kib();
  const std::string start = "GET / HTTP/1.1\r\n" + host_line;
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

TEST_CASE("A HEAD that is refused before it is complete is answered without a body too") {
  const Running server;
  const std::string start = "HEAD /healthz HTTP/1.1\r\n" + host_line;
  for (const auto& [bytes, status] :
       std::vector<std::pair<std::string, std::string>>{{start + "X: " + std::string(100'000, 'a'), "431"},
                                                        {"HEAD /" + std::string(100'000, 'a'), "414"},
                                                        {start, "408"}}) {
    Client client(server.port());
    client.send(bytes);
    const std::string answer = client.rest();
    CAPTURE(answer);
    CHECK(answer.starts_with("HTTP/1.1 " + status + " "));
    CHECK(answer.find("\r\n\r\n") == answer.size() - 4);
  }
}

TEST_CASE("A second request inside a body is never answered") {
  const Running server;
  const std::string inner = "GET /version HTTP/1.1\r\n" + host_line + "\r\n";
  const std::string length = "Content-Length: " + std::to_string(inner.size()) + "\r\n";
  for (const std::string outer : {"GET /healthz", "HEAD /healthz", "GET /nowhere", "GET /", "OPTIONS /v1/nodes"}) {
    CAPTURE(outer);
    Client client(server.port());
    client.send(outer + " HTTP/1.1\r\n" + host_line + length + "\r\n");
    const auto answer = client.receive(outer.starts_with("HEAD"));
    REQUIRE(answer);
    CHECK(answer->status == 400);
    client.send(inner);
    CHECK(client.closed());
  }
  Client client(server.port());
  client.send("POST /nowhere HTTP/1.1\r\n" + host_line + length + "\r\n" + inner);
  const auto answer = client.receive();
  REQUIRE(answer);
  CHECK(answer->status == 404);
  CHECK(client.closed());
}

TEST_CASE("Pipelined requests get one answer and a closed connection") {
  const Running server;
  Client client(server.port());
  std::string requests;
  for (int i = 0; i < 100; ++i) requests += "GET /healthz HTTP/1.1\r\n" + host_line + "\r\n";
  client.send(requests);
  const auto answer = client.receive();
  REQUIRE(answer);
  CHECK(answer->status == 200);
  CHECK(answer->header("connection") == "close");
  CHECK(client.closed());
}

TEST_CASE("Compressed request bodies are not unpacked") {
  const Running server;
  for (const std::string encoding : {"gzip", "br", "deflate"}) {
    const auto answer = ask(server.port(), post_text("/v1/evaluate", "{}", "Content-Encoding: " + encoding + "\r\n"));
    REQUIRE(answer);
    CHECK(answer->status == 415);
  }
}

TEST_CASE("Several ranges are answered with everything, however many they are") {
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
  std::string longest = "Range: bytes=0-1";
  for (int i = 1; i < 2700; ++i) longest += ",0-1";
  CHECK(get(server.port(), "/v1/nodes", longest + "\r\n")->status == 431);
  CHECK(resident_kib() - before < memory_slack_kib);
}

TEST_CASE("Hidden line ends are refused and cannot forge a line of the log") {
  Running server;
  CHECK(get(server.port(), "/a%0d%0ab")->status == 400);
  CHECK(get(server.port(), "/a%00b")->status == 400);
  CHECK(get(server.port(), "/?a=%0a")->status == 400);
  CHECK(get(server.port(), "/", "X: a%0d%0ab: c\r\n")->status == 400);
  CHECK(ask(server.port(), "GET /\x1b[31mred HTTP/1.1\r\n" + host_line + "\r\n")->status == 400);
  CHECK(ask(server.port(), "GET /\nforged HTTP/1.1\r\n" + host_line + "\r\n")->status == 400);
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
    const auto answer = ask(server.port(), "POST /v1/evaluate HTTP/1.1\r\n" + host_line + "Content-Type: " + type +
                                               "\r\nContent-Length: 2\r\n\r\n{}");
    REQUIRE(answer);
    CHECK(answer->status == 415);
  }
}

TEST_CASE("Other protocols and unknown methods end cleanly") {
  const Running server;
  const std::vector<std::pair<std::string, int>> table = {
      {"BREW / HTTP/1.1\r\n" + host_line + "\r\n", 405},
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

TEST_CASE("A token is looked at before a body is read") {
  auto settings = quick_settings();
  settings.token = "secret";
  const Running server(settings);
  const std::string length = "Content-Length: 16000000\r\n";
  Client without(server.port());
  without.send("POST /v1/assets HTTP/1.1\r\n" + host_line + length + "\r\n");
  const auto refused = without.receive();
  REQUIRE(refused);
  CHECK(refused->status == 401);
  CHECK(refused->header("www-authenticate") == "Bearer");
  CHECK(without.closed());
  for (const std::string scheme : {"Bearer", "bearer", "BEARER"}) {
    CHECK(get(server.port(), "/v1/nodes", "Authorization: " + scheme + " secret\r\n")->status == 200);
  }
  CHECK(get(server.port(), "/v1/nodes", "Authorization: Basic secret\r\n")->status == 401);
  CHECK(get(server.port(), "/v1/nodes", "Authorization: Bearer secret2\r\n")->status == 401);
}

TEST_CASE("An unknown address and a wrong method are answered before a body is read") {
  const Running server;
  for (const auto& [line, status] : {std::pair("POST /nowhere", 404), std::pair("POST /healthz", 405)}) {
    Client client(server.port());
    client.send(std::string(line) + " HTTP/1.1\r\n" + host_line + "Content-Length: 1000\r\n\r\n");
    const auto answer = client.receive();
    REQUIRE(answer);
    CHECK(answer->status == status);
    CHECK(client.closed());
  }
}

TEST_CASE("What the standard allows is answered") {
  const Running server;
  const std::string port = std::to_string(server.port());
  const std::vector<std::string> heads = {
      "GET /healthz HTTP/1.0\r\n",
      "GET http://localhost:" + port + "/healthz HTTP/1.1\r\nHost: ignored.example\r\n",
      "GET HTTP://127.0.0.1/healthz HTTP/1.1\r\n" + host_line,
      "GET /healthz?" + std::string(8100, '?') + " HTTP/1.1\r\n" + host_line,
      "GET /healthz HTTP/1.1\r\n" + host_line + "Cookie: other=a%0Ab; more=%00\r\n",
      "GET /healthz HTTP/1.1\r\n" + host_line + "Referer: http://localhost/?x=%0A\r\n",
      "\r\nGET /healthz HTTP/1.1\r\n" + host_line,
      "GET /healthz HTTP/1.1\r\nhOST: LOCALHOST\r\nConnection: Upgrade, HTTP2-Settings\r\nUpgrade: h2c\r\n",
      "GET /%68ealthz HTTP/1.1\r\n" + host_line,
  };
  for (const std::string& head : heads) {
    CAPTURE(head.substr(0, 80));
    const auto answer = ask(server.port(), head + "\r\n");
    REQUIRE(answer);
    CHECK(answer->status == 200);
    CHECK(answer->body == R"({"status":"ok"})");
  }
}

TEST_CASE("Refusals are problems with all headers, whatever is refused") {
  const Running server;
  const std::vector<std::pair<std::string, int>> table = {
      {"GET http:///healthz HTTP/1.1\r\n" + host_line, 400},
      {"GET http://a@localhost/healthz HTTP/1.1\r\n" + host_line, 400},
      {"GET http://evil.example/version HTTP/1.1\r\n" + host_line, 421},
      {"GET http://localhost/healthz HTTP/1.1\r\n" + host_line + host_line, 400},
      {"GET /healthz HTTP/1.1\r\n" + host_line + host_line, 400},
      {"GET /healthz HTTP/1.1\r\n", 400},
      {"GET * HTTP/1.1\r\n" + host_line, 400},
      {"GET healthz HTTP/1.1\r\n" + host_line, 400},
      {"GET /%zz HTTP/1.1\r\n" + host_line, 400},
      {"GET /healthz HTTP/1.1\nHost: localhost\n", 400},
      {"GET /healthz HTTP/1.1\r\n" + host_line + "X: a\r\n folded\r\n", 400},
      {"GET /healthz HTTP/1.1\r\n" + host_line + "X : a\r\n", 400},
      {"POST /v1/validate HTTP/1.1\r\n" + host_line + "Content-Length: 1\r\nContent-Length: 1\r\n", 400},
      {"POST /v1/validate HTTP/1.1\r\n" + host_line + "Content-Length: -1\r\n", 400},
      {"POST /v1/validate HTTP/1.1\r\n" + host_line + "Content-Length: 99999999999999999999\r\n", 400},
      {"POST /v1/validate HTTP/1.1\r\n" + host_line + "Content-Length: 1e3\r\n", 400},
      {"POST /v1/validate HTTP/1.1\r\n" + host_line + "Expect: something\r\nContent-Length: 2\r\n", 417},
      {"GET /version HTTP/1.1\r\nHost: 127.evil.example\r\n", 421},
      {"GET /version HTTP/1.1\r\nHost: localhost.evil.example\r\n", 421},
      {"GET /healthz HTTP/3\r\n" + host_line, 505},
  };
  for (const auto& [head, status] : table) {
    CAPTURE(head);
    const auto answer = ask(server.port(), head + "\r\n");
    REQUIRE(answer);
    CHECK(answer->status == status);
    CHECK(answer->header("content-type") == "application/problem+json");
    CHECK(answer->header("x-content-type-options") == "nosniff");
    CHECK(answer->json()["instance"] == answer->header("x-request-id"));
  }
}

TEST_CASE("Names with ports, proxies and the ports that schemes have are understood") {
  auto settings = quick_settings();
  settings.allowed_hosts = {"model.example", "named.example:8443"};
  const Running server(settings);
  const auto status = [&](const std::string& name, const std::string& origin) {
    const std::string body = R"({"graph":{"nodes":{}}})";
    const auto answer =
        ask(server.port(), "POST /v1/validate HTTP/1.1\r\nHost: " + name +
                               "\r\nContent-Type: application/json\r\nOrigin: " + origin +
                               "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body);
    return answer ? answer->status : 0;
  };
  CHECK(status("model.example", "https://model.example") == 200);
  CHECK(status("model.example:443", "https://model.example") == 200);
  CHECK(status("model.example", "https://model.example:443") == 200);
  CHECK(status("model.example:80", "http://model.example") == 200);
  CHECK(status("named.example:8443", "https://named.example:8443") == 200);
  CHECK(status("named.example:9000", "https://named.example:9000") == 421);
  CHECK(status("127.0.0.1:8080", "https://model.example") ==
        200);  // a proxy that passes on its own idea of a host_line
  CHECK(status("127.0.0.1:8080", "https://evil.example") == 403);
  CHECK(status("127.0.0.1:8080", "http://127.0.0.1:3000") == 403);
  CHECK(status("127.0.0.1:8080", "http://127.0.0.1:8080") == 200);
  CHECK(status("localhost:443", "http://localhost") == 403);
  CHECK(status("model.example", "null") == 403);
  CHECK(status("model.example", "https://model.example.evil.example") == 403);
}

TEST_CASE("The answer for when there is no memory is well formed") {
  const std::string_view answer = dini::server::last_resort();
  const auto end = answer.find("\r\n\r\n");
  REQUIRE(end != std::string_view::npos);
  const std::string_view body = answer.substr(end + 4);
  CHECK(answer.find("Content-Length: " + std::to_string(body.size()) + "\r\n") != std::string_view::npos);
  CHECK(Json::parse(body)["status"] == 503);
}

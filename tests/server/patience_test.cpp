// How long the server waits for its clients, and how much they may hold meanwhile.

#include <vector>

#include "tests/server/fixture.h"

using namespace dini;
using namespace dini::support;

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
  client.send("POST /v1/evaluate HTTP/1.1\r\n" + host_line + "Content-Length: 10\r\n\r\nabc");
  const auto answer = client.receive();
  REQUIRE(answer);
  CHECK(answer->status == 408);
  CHECK(client.closed());
}

TEST_CASE("A connection carries many requests one after the other") {
  const Running server;
  Client client(server.port());
  for (int i = 0; i < 50; ++i) {
    client.send("GET /healthz HTTP/1.1\r\n" + host_line + "\r\n");
    const auto answer = client.receive();
    REQUIRE(answer);
    CHECK(answer->status == 200);
  }
}

TEST_CASE("A client that expects to be told so may send its body") {
  const Running server;
  Client client(server.port());
  client.send("POST /v1/validate HTTP/1.1\r\n" + host_line +
              "Content-Type: application/json\r\nExpect: 100-continue\r\nContent-Length: 22\r\n\r\n");
  const auto go_on = client.receive();
  REQUIRE(go_on);
  CHECK(go_on->status == 100);
  client.send(R"({"graph":{"nodes":{}}})");
  CHECK(client.receive()->status == 200);
}

TEST_CASE("A connection that has been idle too long is closed, also after a computation") {
  auto settings = quick_settings();
  settings.idle_deadline = std::chrono::milliseconds(200);
  const Running server(settings);
  Client client(server.port());
  client.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 20}, {"bytes", 4}})));
  REQUIRE(client.receive());
  CHECK(client.closed());
}

TEST_CASE("A hundred who only connect, and a thousand who drip, hold nobody up and cost no thread") {
  auto settings = quick_settings();
  settings.head_deadline = std::chrono::seconds(5);
  settings.body_deadline = std::chrono::seconds(5);
  const Running server(settings);
  const std::size_t threads = thread_count();
  std::vector<std::unique_ptr<Client>> slow;
  for (int i = 0; i < 1000; ++i) {
    slow.push_back(std::make_unique<Client>(server.port()));
    if (i % 3 == 1) slow.back()->send("GET /healthz HTTP/1.1\r\n" + host_line);
    if (i % 3 == 2)
      slow.back()->send("POST /v1/validate HTTP/1.1\r\n" + host_line + "Content-Length: 1000000\r\n\r\n ");
  }
  for (int i = 0; i < 20; ++i) {
    const auto answer = get(server.port(), "/healthz");
    REQUIRE(answer);
    CHECK(answer->status == 200);
  }
  CHECK(thread_count() == threads);
}

TEST_CASE("Who has been idle longest makes room when every place is taken") {
  auto settings = quick_settings();
  settings.connections = 4;
  settings.idle_deadline = std::chrono::seconds(60);
  settings.head_deadline = std::chrono::seconds(60);
  const Running server(settings);
  std::vector<std::unique_ptr<Client>> idle;
  for (int i = 0; i < 4; ++i) {
    idle.push_back(std::make_unique<Client>(server.port()));
    idle.back()->send("GET /healthz HTTP/1.1\r\n" + host_line + "\r\n");
    REQUIRE(idle.back()->receive());
  }
  CHECK(get(server.port(), "/healthz")->status == 200);
  CHECK(idle.front()->closed());
  idle.back()->send("GET /healthz HTTP/1.1\r\n" + host_line + "\r\n");
  CHECK(idle.back()->receive()->status == 200);
}

TEST_CASE("Bodies that arrive share a budget of memory") {
  auto settings = quick_settings();
  settings.incoming_bytes = 150'000;
  settings.body_deadline = std::chrono::seconds(10);
  const Running server(settings);
  const std::string head =
      "POST /v1/validate HTTP/1.1\r\n" + host_line + "Content-Type: application/json\r\nContent-Length: 100001\r\n\r\n";
  Client first(server.port()), second(server.port());
  first.send(head + std::string(100'000, ' '));
  // Once the first one's bytes are here, the second one's find no room.
  REQUIRE(eventually([&] {
    Client probe(server.port());
    probe.send(head + std::string(100'000, ' '));
    const auto answer = probe.receive();
    return answer && answer->status == 503;
  }));
  first.send("1");
  CHECK(first.receive()->status == 422);
  second.send(head + std::string(100'000, ' ') + "1");
  CHECK(second.receive()->status == 422);
}

TEST_CASE("A reader that takes nothing is cut") {
  auto settings = quick_settings();
  settings.write_deadline = std::chrono::milliseconds(200);
  Running server(settings);
  Client client(server.port());
  client.send(post_text("/v1/evaluate", toy_body({{"bytes", 50'000'000}})));
  Client other(server.port());
  other.send("GET /healthz HTTP/1.1\r\n" + host_line + "\r\n");
  CHECK(other.receive()->status == 200);
  REQUIRE(eventually([&] { return server.log().find("/v1/evaluate 200") != std::string::npos; }));
  CHECK(client.rest().size() < 50'000'000);
}

TEST_CASE("A thousand who connect at once are all answered") {
  const Running server;
  std::vector<std::unique_ptr<Client>> clients;
  for (int i = 0; i < 1000; ++i) clients.push_back(std::make_unique<Client>(server.port()));
  for (const auto& client : clients) client->send("GET /healthz HTTP/1.1\r\n" + host_line + "\r\n");
  for (const auto& client : clients) {
    const auto answer = client->receive();
    REQUIRE(answer);
    CHECK(answer->status == 200);
  }
}

TEST_CASE("Who has connected before the server stops is answered") {
  Running server;
  std::vector<std::unique_ptr<Client>> clients;
  for (int i = 0; i < 400; ++i) {
    clients.push_back(std::make_unique<Client>(server.port()));
    clients.back()->send("GET /v1/nodes HTTP/1.1\r\n" + host_line + "\r\n");
  }
  server.stop();
  for (const auto& client : clients) {
    const auto answer = client->receive();
    REQUIRE(answer);
    CHECK(answer->status == 200);
  }
}

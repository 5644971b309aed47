// Who computes, who waits, who is turned away, and what makes a computation end.

#include <future>

#include "tests/server/fixture.h"

using namespace dini;
using namespace dini::support;

namespace {

bool all_finished() { return toy::counters().started == toy::counters().finished; }

}  // namespace

TEST_CASE("A hundred identical requests are one evaluation in one place") {
  const Running server;  // one slot, one place in the queue
  const std::size_t before = toy::counters().started;
  const std::string bytes = post_text("/v1/evaluate", toy_body({{"milliseconds", 300}, {"bytes", 9}}));
  std::vector<std::unique_ptr<Client>> clients;
  for (int i = 0; i < 100; ++i) {
    clients.push_back(std::make_unique<Client>(server.port()));
    clients.back()->send(bytes);
  }
  for (const auto& client : clients) {
    const auto answer = client->receive();
    REQUIRE(answer);
    CHECK(answer->status == 200);
    CHECK(answer->body == "ggggggggg");
  }
  CHECK(toy::counters().started == before + 1);
}

TEST_CASE("What is known is answered while every place is taken") {
  const Running server;
  const std::string known = toy_body({{"bytes", 5}});
  REQUIRE(post(server.port(), "/v1/evaluate", known)->status == 200);
  const std::size_t before = toy::counters().started;
  Client running(server.port()), waiting(server.port());
  running.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}, {"bytes", 1}})));
  waiting.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}, {"bytes", 2}})));
  REQUIRE(eventually([&] { return toy::counters().started > before; }));
  REQUIRE(eventually([&] { return get(server.port(), "/readyz")->status == 503; }));  // the queue is full
  for (int i = 0; i < 20; ++i) {
    CHECK(post(server.port(), "/v1/evaluate", known)->status == 200);
    CHECK(post(server.port(), "/v1/validate", known)->status == 200);
  }
}

TEST_CASE("A newer request that is turned away leaves the older one alone, a wrong one does not") {
  const Running server;
  const std::size_t before = toy::counters().started;
  const std::string key = "Supersede-Key: slider\r\n";
  Client running(server.port()), older(server.port()), newer(server.port());
  running.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}, {"bytes", 1}})));
  REQUIRE(eventually([&] { return toy::counters().started > before; }));
  const std::size_t prepared = toy::counters().prepared;
  older.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 1}, {"bytes", 2}}), key));
  REQUIRE(eventually([&] { return toy::counters().prepared > prepared; }));
  // The one place in the queue is taken once others are refused.
  REQUIRE(eventually([&] {
    return post(server.port(), "/v1/evaluate", toy_body({{"milliseconds", 60'000}, {"bytes", 3}}))->status == 503;
  }));
  CHECK(post(server.port(), "/v1/evaluate", toy_body({{"bytes", 4}}), key)->status == 503);
  running.close();
  const auto answer = older.receive();
  REQUIRE(answer);
  CHECK(answer->status == 200);

  const std::size_t again = toy::counters().started;
  newer.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}, {"bytes", 5}}), key));
  REQUIRE(eventually([&] { return toy::counters().started > again; }));
  CHECK(post(server.port(), "/v1/evaluate", toy_body({{"invalid", "out-of-range"}}), key)->status == 422);
  CHECK(newer.receive()->status == 409);
}

TEST_CASE("Want of memory is told and passes") {
  const Running server;
  const auto answer = post(server.port(), "/v1/evaluate", toy_body({{"memory", true}}));
  REQUIRE(answer);
  CHECK(answer->status == 503);
  CHECK(answer->code() == "out-of-memory");
  CHECK(answer->header("retry-after") == "1");
  CHECK(post(server.port(), "/v1/evaluate", toy_body({{"bytes", 1}}))->status == 200);
}

TEST_CASE("A deadline ends an evaluation with 504") {
  const Running server;
  Json body = Json::parse(toy_body({{"milliseconds", 60'000}}));
  body["deadline_ms"] = 50;
  const auto answer = post(server.port(), "/v1/evaluate", body.dump());
  REQUIRE(answer);
  CHECK(answer->status == 504);
  CHECK(answer->code() == "deadline");
  CHECK(answer->json()["detail"].get<std::string>().find("deadline of 50 ms; ") != std::string::npos);
  CHECK(eventually(all_finished));
}

TEST_CASE("A newer request with the same key supersedes the older one") {
  const Running server;
  const std::size_t before = toy::counters().started;
  auto older = std::async(std::launch::async, [&] {
    return post(server.port(), "/v1/evaluate", toy_body({{"milliseconds", 60'000}}), "Supersede-Key: drag\r\n");
  });
  REQUIRE(eventually([&] { return toy::counters().started > before; }));
  CHECK(post(server.port(), "/v1/evaluate", toy_body({{"bytes", 1}}), "Supersede-Key: drag\r\n")->status == 200);
  const auto answer = older.get();
  REQUIRE(answer);
  CHECK(answer->status == 409);
  CHECK(answer->code() == "superseded");
}

TEST_CASE("Evaluations beyond slots and queue are refused at once") {
  const Running server;  // one slot, one place in the queue
  const std::size_t before = toy::counters().started;
  Client running(server.port());
  running.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}})));
  REQUIRE(eventually([&] { return toy::counters().started > before; }));
  std::vector<std::future<std::optional<Answer>>> more;
  for (int i = 0; i < 2; ++i) {
    more.push_back(std::async(std::launch::async, [&server, i] {
      const Json other{{"graph", {{"nodes", Json::object()}}}, {"node", "out"}, {"output", "o" + std::to_string(i)}};
      return post(server.port(), "/v1/inspect", other.dump());
    }));
  }
  // One of the two finds the place in the queue, the other one is told so before the first is done.
  std::size_t refused = more.size();
  REQUIRE(eventually([&] {
    for (std::size_t i = 0; i < more.size(); ++i) {
      if (more[i].wait_for(std::chrono::seconds(0)) == std::future_status::ready) refused = i;
    }
    return refused < more.size();
  }));
  const auto answer = more[refused].get();
  REQUIRE(answer);
  CHECK(answer->status == 503);
  CHECK(answer->header("retry-after") == "1");
  CHECK(get(server.port(), "/healthz")->status == 200);
  running.close();  // frees the slot for the one that waits
  const auto waited = more[1 - refused].get();
  REQUIRE(waited);
  CHECK(waited->status == 200);
}

TEST_CASE("A client that has only finished sending still gets its answer") {
  const Running server;
  for (const int milliseconds : {0, 150}) {
    Client client(server.port());
    client.send(post_text("/v1/evaluate", toy_body({{"milliseconds", milliseconds}, {"bytes", 40 + milliseconds}})));
    client.finish_sending();
    const auto answer = client.receive();
    REQUIRE(answer);
    CHECK(answer->status == 200);
    CHECK(answer->body == std::string(static_cast<std::size_t>(40 + milliseconds), 'g'));
    CHECK(client.closed());
  }
}

TEST_CASE("A client that leaves stops its evaluation") {
  const Running server;
  const std::size_t canceled = toy::counters().canceled;
  const std::size_t started = toy::counters().started;
  Client client(server.port());
  client.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}})));
  REQUIRE(eventually([&] { return toy::counters().started > started; }));
  client.close();
  CHECK(eventually([&] { return toy::counters().canceled > canceled; }));
  CHECK(eventually(all_finished));
}

TEST_CASE("Stopping the server lets a running request finish and closes idle connections") {
  Running server;
  Client idle(server.port());
  idle.send("GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n");
  REQUIRE(idle.receive());
  const std::size_t before = toy::counters().started;
  Client busy(server.port());
  busy.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 300}, {"bytes", 2}})));
  REQUIRE(eventually([&] { return toy::counters().started > before; }));
  server.stop();
  const auto answer = busy.receive();
  REQUIRE(answer);
  CHECK(answer->status == 200);
  CHECK(answer->header("connection") == "close");
  CHECK(idle.closed());
}

TEST_CASE("What still runs at the drain deadline is stopped and told so") {
  auto settings = quick_settings();
  settings.drain_deadline = std::chrono::milliseconds(100);
  Running server(settings);
  const std::size_t before = toy::counters().started;
  Client busy(server.port());
  busy.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}})));
  REQUIRE(eventually([&] { return toy::counters().started > before; }));
  server.stop();
  const auto answer = busy.receive();
  REQUIRE(answer);
  CHECK(answer->status == 503);
  CHECK(answer->code() == "shutting-down");
}

TEST_CASE("Where memory runs out, what could be made again is let go of, and the next request is answered") {
  const Running server;
  const std::string known = toy_body({{"bytes", 7}});
  REQUIRE(post(server.port(), "/v1/evaluate", known)->status == 200);
  const std::size_t before = toy::counters().started;
  REQUIRE(post(server.port(), "/v1/evaluate", known)->status == 200);
  CHECK(toy::counters().started == before);
  const auto refused = post(server.port(), "/v1/evaluate", toy_body({{"memory", true}}));
  CHECK(refused->status == 503);
  CHECK(refused->code() == "out-of-memory");
  CHECK(post(server.port(), "/v1/evaluate", known)->status == 200);
  CHECK(toy::counters().started == before + 2);
}

#include <atomic>
#include <catch2/catch.hpp>
#include <fstream>
#include <future>
#include <signal.h>

#include "tests/cli/serving.h"
#include "tests/server/client.h"
#include "tests/support/eventually.h"

using namespace dini;
using namespace dini::support;

namespace {

/// What one client was answered that sends request after request until it is told that the connection ends.
struct Answered {
  std::size_t well = 0;
  std::vector<std::string> wrong;
};

/// `come` counts the clients that have been answered once.
Answered ask_until_told_to_go(int port, int client, std::atomic<int>& come) {
  Client connection(port);
  Answered answered;
  for (int i = 0;; ++i) {
    const std::string request = i % 2 == 0
                                    ? post_text("/v1/evaluate", toy_body({{"milliseconds", 3}, {"bytes", client + 1}}))
                                    : "GET /healthz HTTP/1.1\r\n" + host_line + "\r\n";
    connection.send(request);
    const auto answer = connection.receive();
    if (!answer || answer->status != 200) {
      answered.wrong.push_back(answer ? answer->body : "no answer to request " + std::to_string(i));
      return answered;
    }
    if (++answered.well == 1) ++come;
    if (answer->header("connection") == "close") return answered;
  }
}

}  // namespace

TEST_CASE("A server that is told to stop under load fails no request, and ends with 0") {
  ServingProgram server({"--log-level", "off"});
  constexpr int all = 6;
  std::atomic<int> come = 0;
  std::vector<std::future<Answered>> clients;
  for (int client = 0; client < all; ++client) {
    clients.push_back(std::async(std::launch::async, ask_until_told_to_go, server.port(), client, std::ref(come)));
  }
  REQUIRE(eventually([&] {
    if (come < all) return false;
    const std::string metrics = get(server.port(), "/metrics")->body;
    const auto count = metrics.find("dini_requests_total{method=\"POST\"");
    return count != std::string::npos && std::stoi(metrics.substr(metrics.find(' ', count))) > 60;
  }));
  server.program().signal(SIGTERM);
  for (auto& client : clients) {
    const Answered answered = client.get();
    CAPTURE(answered.wrong);
    CHECK(answered.wrong.empty());
    CHECK(answered.well > 0);
  }
  const Outcome outcome = server.program().wait();
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
}

TEST_CASE("A server that is told to stop takes nobody new, and tells who is there that it is not ready") {
  ServingProgram server({"--log-level", "off"});
  Client busy(server.port()), probe(server.port());
  busy.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}})));
  REQUIRE(get(server.port(), "/healthz")->status == 200);
  // The head is complete only after the signal; the server waits for the rest of it.
  probe.send("GET /readyz HTTP/1.1\r\n");
  Client idle(server.port());
  REQUIRE(get(server.port(), "/healthz")->status == 200);  // who came before has been let in
  server.program().signal(SIGTERM);
  REQUIRE(idle.closed());
  CHECK(Client(server.port()).closed());
  probe.send(host_line + "\r\n");
  const auto answer = probe.receive();
  REQUIRE(answer);
  CHECK(answer->status == 503);
  CHECK(answer->code() == "shutting-down");
  CHECK(answer->header("connection") == "close");
  CHECK(answer->header("retry-after") == "1");
  server.program().signal(SIGKILL);
}

TEST_CASE("What still runs at the end of drain_milliseconds is told so, and the server ends with 0") {
  ServingProgram server({"--log-level", "off", "--drain-milliseconds", "200"});
  Client busy(server.port()), idle(server.port());
  busy.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}})));
  REQUIRE(get(server.port(), "/healthz")->status == 200);
  server.program().signal(SIGTERM);
  const auto answer = busy.receive();
  REQUIRE(answer);
  CHECK(answer->status == 503);
  CHECK(answer->code() == "shutting-down");
  CHECK(server.program().wait().code == 0);
}

TEST_CASE("Whoever is connected and asks nothing does not keep a server from ending") {
  // With these, a connection that were waited for would be waited for for minutes.
  ServingProgram server({"--log-level", "off", "--idle-milliseconds", "600000", "--drain-milliseconds", "600000"});
  Client idle(server.port()), used(server.port());
  used.send("GET /healthz HTTP/1.1\r\n" + host_line + "\r\n");
  REQUIRE(used.receive());
  server.program().signal(SIGTERM);
  CHECK(idle.closed());
  CHECK(used.closed());
  CHECK(server.program().wait().code == 0);
}

TEST_CASE("A second signal ends a server at once") {
  ServingProgram server({"--log-level", "off", "--drain-milliseconds", "600000"});
  Client busy(server.port()), idle(server.port());
  busy.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}})));
  REQUIRE(get(server.port(), "/healthz")->status == 200);
  server.program().signal(SIGTERM);
  REQUIRE(idle.closed());  // the first signal has been heard
  server.program().signal(SIGTERM);
  CHECK(server.program().wait().code == 128 + SIGTERM);
}

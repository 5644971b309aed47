// The log of a server as a whole program writes it.

#include <algorithm>
#include <set>
#include <signal.h>
#include <sstream>

#include "tests/cli/serving.h"
#include "tests/server/client.h"

using namespace dini;
using namespace dini::support;

namespace {

std::vector<dini::Json> json_lines(const std::string& text) {
  std::vector<dini::Json> lines;
  std::istringstream rest(text);
  for (std::string line; std::getline(rest, line);) {
    INFO(line);
    lines.push_back(dini::Json::parse(line, nullptr, false));
    CHECK(lines.back().is_object());
    CHECK(lines.back().contains("time"));
    CHECK(lines.back().contains("level"));
    CHECK(lines.back().contains("message"));
  }
  return lines;
}

/// The line of the request with that name; null when there is none.
dini::Json line_of(const std::vector<dini::Json>& lines, const std::string& id) {
  const auto found = std::ranges::find_if(lines, [&](const dini::Json& line) { return line.value("id", "") == id; });
  return found == lines.end() ? dini::Json() : *found;
}

/// The log of a server after these requests.
std::vector<dini::Json> log_of(ServingProgram& server) {
  server.program().signal(SIGTERM);
  const Outcome outcome = server.program().wait();
  CHECK(outcome.code == 0);
  CHECK(outcome.out.empty());
  return json_lines(outcome.err);
}

}  // namespace

TEST_CASE("In JSON every line of the log is an object, from the first to the last") {
  ServingProgram server({"--log-format", "json"});
  const std::string name = "X-Request-Id: one\r\n";
  CHECK(get(server.port(), "/healthz?a=\"\\", name)->header("x-request-id") == "one");
  CHECK(get(server.port(), "/\x1b[31m")->status == 400);
  CHECK(ask(server.port(), "no \"http\"\r\n\r\n")->status == 400);
  const auto lines = log_of(server);
  REQUIRE(lines.size() >= 5);
  CHECK(lines.front().at("message").get<std::string>().starts_with("Dini listens on http://127.0.0.1:"));
  const dini::Json line = line_of(lines, "one");
  CHECK(line["message"] == "request");
  CHECK(line["level"] == "info");
  CHECK(line["method"] == "GET");
  CHECK(line["path"] == "/healthz?a=\"\\");
  CHECK(line["route"] == "/healthz");
  CHECK(line["bytes"].get<int>() > 100);
  CHECK(line["milliseconds"].at("total").get<double>() >= 0);
}

TEST_CASE("The line of an evaluation tells its stages, its graph, and whether the result was known") {
  ServingProgram server({"--log-format", "json"});
  const std::string body = toy_body({{"bytes", 3}});
  const auto first = post(server.port(), "/v1/evaluate", body, "X-Request-Id: first\r\n");
  CHECK(first->status == 200);
  CHECK(post(server.port(), "/v1/evaluate", body, "X-Request-Id: second\r\n")->status == 200);
  CHECK(post(server.port(), "/v1/evaluate", body,
             "X-Request-Id: third\r\nIf-None-Match: " + first->header("etag") + "\r\n")
            ->status == 304);
  const auto lines = log_of(server);
  const dini::Json made = line_of(lines, "first"), known = line_of(lines, "second"), same = line_of(lines, "third");
  CHECK(made["route"] == "/v1/evaluate");
  CHECK(made["status"] == 200);
  CHECK(made["cache"] == "miss");
  CHECK(known["cache"] == "hit");
  CHECK(same["cache"] == "304");
  for (const char* stage : {"total", "queue", "check"}) CHECK(made["milliseconds"].contains(stage));
  CHECK(made["graph"].get<std::string>().size() == 64);
  CHECK(known["graph"] == made["graph"]);
}

TEST_CASE("Nothing secret is in the log, in either form") {
  const std::string form = GENERATE("text", "json");
  ServingProgram server({"--log-format", form, "--token", "swordfish", "--log-level", "trace"});
  const std::string body = R"({"graph": {"dini": 1, "nodes": {"my_private_node": {"type": "none"}}}})";
  CHECK(post(server.port(), "/v1/evaluate", body, "Authorization: Bearer swordfish\r\n")->status == 200);
  CHECK(post(server.port(), "/v1/evaluate", body, "Authorization: Bearer tunafish\r\n")->status == 401);
  server.program().signal(SIGTERM);
  const Outcome outcome = server.program().wait();
  for (const char* secret : {"swordfish", "tunafish", "my_private_node"}) {
    CHECK(outcome.err.find(secret) == std::string::npos);
    CHECK(outcome.out.find(secret) == std::string::npos);
  }
  CHECK(outcome.err.find("/v1/evaluate") != std::string::npos);
}

TEST_CASE("A trace is in the log and in nothing that is answered") {
  ServingProgram server({"--log-format", "json"});
  const std::string trace = "4bf92f3577b34da6a3ce929d0e0e4736", span = "00f067aa0ba902b7";
  const auto asked = [&](const std::string& id, const std::string& parent) {
    const auto answer = get(server.port(), "/healthz", "X-Request-Id: " + id + "\r\ntraceparent: " + parent + "\r\n");
    REQUIRE(answer);
    CHECK(answer->status == 200);
    for (const auto& [name, value] : answer->headers) CHECK(value.find(trace) == std::string::npos);
  };
  asked("good", "00-" + trace + "-" + span + "-01");
  asked("later", "01-" + trace + "-" + span + "-01-more");
  const std::vector<std::string> bad = {"00-" + trace + "-" + span + "-01-more",
                                        "ff-" + trace + "-" + span + "-01",
                                        "00-" + std::string(32, '0') + "-" + span + "-01",
                                        "00-" + trace + "-" + std::string(16, '0') + "-01",
                                        "00-4BF92F3577B34DA6A3CE929D0E0E4736-" + span + "-01",
                                        "00-" + trace + "-" + span + "-0x",
                                        "00-" + trace + "-" + span,
                                        "none",
                                        ""};
  for (std::size_t i = 0; i < bad.size(); ++i) asked("bad" + std::to_string(i), bad[i]);
  const auto lines = log_of(server);
  CHECK(line_of(lines, "good")["trace"] == trace);
  CHECK(line_of(lines, "good")["span"] == span);
  CHECK(line_of(lines, "later")["trace"] == trace);
  for (std::size_t i = 0; i < bad.size(); ++i) {
    const dini::Json line = line_of(lines, "bad" + std::to_string(i));
    INFO(bad[i]);
    CHECK(line.is_object());
    CHECK_FALSE(line.contains("trace"));
  }
}

TEST_CASE("The name that a client gives its request is taken when it is sane, and else a new one is made") {
  ServingProgram server({"--log-level", "off"});
  const auto named = [&](const std::string& id) {
    return get(server.port(), "/healthz", "X-Request-Id: " + id + "\r\n")->header("x-request-id");
  };
  CHECK(named("2b9f.A_z-9") == "2b9f.A_z-9");
  CHECK(named(std::string(64, 'a')) == std::string(64, 'a'));
  std::set<std::string> made;
  for (const std::string& id : std::vector<std::string>{"", "a b", "a\"b", "a=b", "\xc3\xa4", std::string(65, 'a')}) {
    CHECK(named(id) != id);
    made.insert(named(id));
  }
  CHECK(made.size() == 6);
  const auto wrong = get(server.port(), "/nowhere", "X-Request-Id: mine\r\n");
  CHECK(wrong->json()["instance"] == "mine");
}

TEST_CASE("A server that cannot start says why in the form of its log") {
  ServingProgram server;
  const Outcome taken = run_dini({"serve", "--log-format", "json", "--port", std::to_string(server.port())});
  CHECK(taken.code == 6);
  const auto lines = json_lines(taken.err);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0]["level"] == "critical");
  CHECK(lines[0]["message"].get<std::string>().starts_with("error: Cannot listen on 127.0.0.1 port "));
}

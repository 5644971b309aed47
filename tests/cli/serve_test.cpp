#include <catch2/catch.hpp>
#include <signal.h>

#include "server/server_limits.h"
#include "tests/cli/serving.h"
#include "tests/cli/variable.h"
#include "tests/server/client.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A value for a limit that is not its default.
template <class Owner>
std::uint64_t another(const dini::Limit<Owner>& limit) {
  const std::uint64_t usual = limit.get(Owner{});
  return usual < limit.most ? usual + 1 : usual - 1;
}

template <class Owner>
void set_all(std::span<const dini::Limit<Owner>> limits, std::vector<std::string>& words, dini::Json& expected) {
  for (const dini::Limit<Owner>& limit : limits) {
    words.push_back(dini::flag_of(limit.name));
    words.push_back(std::to_string(another(limit)));
    expected[std::string(limit.name)] = another(limit);
  }
}

}  // namespace

TEST_CASE("Every limit has an option, and /version tells what it was set to") {
  std::vector<std::string> words;
  dini::Json expected = dini::Json::object();
  set_all(dini::evaluation_limits(), words, expected);
  set_all(dini::server::server_limits(), words, expected);
  ServingProgram server(words);
  CHECK(get(server.port(), "/version")->json()["limits"] == expected);
}

TEST_CASE("A limit comes from its environment variable, unless its option is given") {
  const Variable depth("DINI_JSON_DEPTH", "7"), nodes("DINI_NODES", "8");
  ServingProgram server({"--nodes", "9"});
  const dini::Json limits = get(server.port(), "/version")->json()["limits"];
  CHECK(limits["json_depth"] == 7);
  CHECK(limits["nodes"] == 9);
}

TEST_CASE("A limit that is out of its range is refused, and help tells unit and default") {
  for (const std::string wrong : {"-1", "100000", "many", "1.5"}) {
    CHECK(run_dini({"serve", "--port", "0", "--json-depth", wrong}).code == 2);
  }
  const std::string help = run_dini({"serve", "--help"}).out;
  CHECK(help.find("--body-bytes") != std::string::npos);
  CHECK(help.find("DINI_BODY_BYTES") != std::string::npos);
  CHECK(help.find("(default 1048576)") != std::string::npos);
}

TEST_CASE("The server says where it listens, and ends with 0 when told to") {
  for (const int number : {SIGTERM, SIGINT}) {
    ServingProgram server;
    CHECK(get(server.port(), "/healthz")->status == 200);
    Client idle(server.port());
    server.program().signal(number);
    const Outcome outcome = server.program().wait();
    CHECK(outcome.code == 0);
    CHECK(outcome.out.starts_with("Dini listens on http://127.0.0.1:" + std::to_string(server.port()) + "/\n"));
    CHECK(outcome.err.find("GET /healthz 200") != std::string::npos);
  }
}

TEST_CASE("A running request is finished before the server ends") {
  ServingProgram server({"--log-level", "off"});
  Client busy(server.port());
  busy.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 500}, {"bytes", 2}})));
  // Requests are read in the order in which they come, so this one has been read when a later one is answered.
  REQUIRE(get(server.port(), "/healthz")->status == 200);
  server.program().signal(SIGTERM);
  const auto answer = busy.receive();
  REQUIRE(answer);
  CHECK(answer->body == "gg");
  const Outcome outcome = server.program().wait();
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
}

TEST_CASE("A token opens addresses other than loopback") {
  ServingProgram server({"--host", "0.0.0.0", "--token", "swordfish"});
  CHECK(get(server.port(), "/v1/nodes")->status == 401);
  CHECK(get(server.port(), "/v1/nodes", "Authorization: Bearer swordfish\r\n")->status == 200);
}

TEST_CASE("A server that cannot start says why") {
  ServingProgram server;
  const Outcome taken = run_dini({"serve", "--port", std::to_string(server.port())});
  CHECK(taken.code == 6);
  CHECK(taken.err.starts_with("error: Cannot listen on 127.0.0.1 port "));
  CHECK(run_dini({"serve", "--port", "0", "--web", "/nowhere"}).code == 6);
  CHECK(run_dini({"serve", "--port", "0", "--examples", "/nowhere"}).code != 0);
}

TEST_CASE("A program that is installed finds its page beside it") {
  const Folder folder;
  folder.write("share/dini/web/index.html", "the page");
  std::filesystem::create_directories(folder.path() / "bin");
  std::filesystem::copy_file(dini_path(), folder.path() / "bin" / "dini");
  ServingProgram server({"--log-level", "off"}, (folder.path() / "bin" / "dini").string());
  CHECK(get(server.port(), "/")->body == "the page");
}

TEST_CASE("A server with hardly any descriptors answers again as soon as it has some") {
  ServingProgram server({}, dini_path(), {"/usr/bin/prlimit", "--nofile=64"});
  {
    std::vector<std::unique_ptr<Client>> idle;
    for (int i = 0; i < 200; ++i) idle.push_back(std::make_unique<Client>(server.port()));
  }
  CHECK(eventually([&] {
    const auto answer = get(server.port(), "/healthz");
    return answer && answer->status == 200;
  }));
  server.program().signal(SIGTERM);
  CHECK(server.program().wait().code == 0);
}

TEST_CASE("Threads of small stacks are enough for long addresses and deep documents") {
#ifdef __SANITIZE_ADDRESS__
  constexpr int bytes = 1024 * 1024;  // what it looks for takes room of its own
#else
  constexpr int bytes = 256 * 1024;
#endif
  ServingProgram server({}, dini_path(), {"/usr/bin/prlimit", "--stack=" + std::to_string(bytes)});
  for (const char* path : {"/", "/v1/nodes/", "/v1/graphs/", "/v1/artifacts/", "/assets/", "/embed/"}) {
    const auto answer = get(server.port(), path + std::string(8000, 'a'));
    REQUIRE(answer);
    CHECK((answer->status == 404 || answer->status == 414));
  }
  for (const char bracket : {'[', '{'}) {
    const auto answer = post(server.port(), "/v1/evaluate", std::string(200'000, bracket));
    REQUIRE(answer);
    CHECK(answer->status == 400);
  }
  CHECK(get(server.port(), "/healthz")->status == 200);
}

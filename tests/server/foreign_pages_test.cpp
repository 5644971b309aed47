// What a page of another site, or a name that is not ours, gets from every address: nothing, whatever the address is.

#include "server/routes.h"
#include "tests/server/fixture.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A request line for a route, with a word where its path has braces.
struct Asked {
  std::string method;
  std::string path;

  bool changes() const { return method != "GET"; }
  bool is_probe() const { return path == "/healthz" || path == "/readyz"; }
};

/// Every address that the server answers: those of its routes and a file of the page.
std::vector<Asked> all_addresses() {
  std::vector<Asked> all = {{"GET", "/main-5ZQ2W7KD.js"}, {"GET", "/nowhere"}};
  for (const server::Route& route : server::routes()) {
    Asked asked{std::string(route.method), std::string(route.path)};
    while (asked.path.find('{') != std::string::npos) {
      asked.path.replace(asked.path.find('{'), asked.path.find('}') - asked.path.find('{') + 1, "x");
    }
    all.push_back(asked);
  }
  return all;
}

std::optional<Answer> ask_for(int port, const Asked& asked, const std::string& host, const std::string& headers = "") {
  const bool has_body = asked.method == "POST" || asked.method == "PUT";
  return ask(port, asked.method + " " + asked.path + " HTTP/1.1\r\nHost: " + host + "\r\n" + headers +
                       (has_body ? "Content-Length: 2\r\n" : "") + "Connection: close\r\n\r\n" +
                       (has_body ? "{}" : ""));
}

/// A server with a page, whose files stand in the given folder.
server::Settings with_page(const Folder& folder) {
  folder.write("index.html", "<html>");
  folder.write("main-5ZQ2W7KD.js", "let a");
  auto settings = quick_settings();
  settings.web = folder.path();
  return settings;
}

}  // namespace

TEST_CASE("Under a name that is not ours every address but the probes is refused, files of the page too") {
  const Folder folder;
  const Running server(with_page(folder));
  for (const Asked& asked : all_addresses()) {
    for (const std::string host : {"evil.example", "evil.example:8080", "localhost.evil.example", "[2001:db8::1]"}) {
      CAPTURE(asked.method, asked.path, host);
      const auto answer = ask_for(server.port(), asked, host);
      REQUIRE(answer);
      CHECK((answer->status == 421) == !asked.is_probe());
    }
  }
}

TEST_CASE("Nothing is changed for a page of another origin, however its origin is written") {
  const Running server;
  struct Case {
    std::string host, origin;
    bool ours;
  };
  const std::vector<Case> table = {
      {"localhost:8080", "http://localhost:8080", true},
      {"localhost:8080", "HTTP://LocalHost:8080", true},
      {"localhost:8080", "http://localhost", false},
      {"localhost:8080", "http://localhost:80", false},
      {"localhost:8080", "http://localhost:8081", false},
      {"localhost:8080", "http://localhost:8080.evil.example", false},
      {"localhost:8080", "http://evil.example", false},
      {"localhost:8080", "localhost:8080", false},
      {"localhost:8080", "file://", false},
      {"localhost:8080", "null", false},
      {"localhost:8080", "", false},
      {"[::1]:8080", "http://[::1]:8080", true},
      {"[::1]:8080", "http://[::1]", false},
      {"[::1]:8080", "http://[::1]:8081", false},
      {"[::1]:8080", "http://::1:8080", false},
      {"[::1]:8080", "http://[0:0:0:0:0:0:0:1]:8081", false},
      {"127.0.0.1:8080", "http://localhost:8080", false},
  };
  for (const Asked& asked : all_addresses()) {
    if (!asked.changes()) continue;
    for (const Case& each : table) {
      CAPTURE(asked.method, asked.path, each.host, each.origin);
      const auto answer = ask_for(server.port(), asked, each.host, "Origin: " + each.origin + "\r\n");
      REQUIRE(answer);
      CHECK((answer->status == 403) == !each.ours);
      if (!each.ours) CHECK(answer->code() == "foreign-origin");
    }
  }
}

TEST_CASE("No address takes a body that forms of pages send, and only files may be plain text") {
  const Running server;
  for (const server::Route& route : server::routes()) {
    if (route.body_limit == nullptr) continue;
    std::string path(route.path);
    if (path.ends_with("{id}")) path.replace(path.find('{'), 4, "x");
    for (const std::string type : {"text/plain", "text/plain;charset=UTF-8", "application/x-www-form-urlencoded",
                                   "multipart/form-data; boundary=x", ""}) {
      CAPTURE(path, type);
      // A mesh file may be plain text: a page that sends one names its origin, and is refused for that.
      if (path == "/v1/assets" && type.starts_with("text/plain")) continue;
      const auto answer =
          ask(server.port(), std::string(route.method) + " " + path + " HTTP/1.1\r\nHost: localhost\r\n" +
                                 (type.empty() ? "" : "Content-Type: " + type + "\r\n") +
                                 "If-None-Match: *\r\nContent-Length: 2\r\nConnection: close\r\n\r\n{}");
      REQUIRE(answer);
      CHECK(answer->status == 415);
    }
  }
}

TEST_CASE("A browser that asks for a page of another origin is told nothing that lets it in") {
  auto settings = quick_settings();
  settings.allowed_origins = {"https://site.example"};
  for (const auto& each : {quick_settings(), settings}) {
    const Running server(each);
    for (const Asked& asked : all_addresses()) {
      CAPTURE(asked.method, asked.path);
      const auto answer = ask(server.port(), "OPTIONS " + asked.path +
                                                 " HTTP/1.1\r\nHost: localhost\r\nOrigin: https://evil.example\r\n"
                                                 "Access-Control-Request-Method: " +
                                                 asked.method + "\r\n\r\n");
      REQUIRE(answer);
      for (const auto& [name, value] : answer->headers) {
        CAPTURE(name, value);
        CHECK(name.find("ccess-") == std::string::npos);
      }
    }
  }
}

TEST_CASE("Every answer keeps browsers from guessing its type, framing it and sharing it") {
  const Folder folder;
  const Running server(with_page(folder));
  for (const Asked& asked : all_addresses()) {
    CAPTURE(asked.method, asked.path);
    const auto answer = ask_for(server.port(), asked, "localhost");
    REQUIRE(answer);
    CHECK(answer->header("content-security-policy").find("frame-ancestors 'none'") != std::string::npos);
    CHECK(answer->header("x-content-type-options") == "nosniff");
    CHECK(answer->header("cross-origin-opener-policy") == "same-origin");
    CHECK(answer->header("cross-origin-resource-policy") == "same-origin");
  }
}

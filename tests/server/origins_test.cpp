// What an address takes, and what pages of other origins may do with it.

#include "tests/server/fixture.h"

using namespace dini;
using namespace dini::support;

namespace {

const std::string site = "https://site.example";

std::optional<Answer> options(int port, const std::string& path, const std::string& headers = "") {
  return ask(port, "OPTIONS " + path + " HTTP/1.1\r\nHost: localhost\r\n" + headers + "\r\n");
}

server::Settings letting_in(std::vector<std::string> origins) {
  auto settings = quick_settings();
  settings.allowed_origins = std::move(origins);
  return settings;
}

}  // namespace

TEST_CASE("OPTIONS tells what an address takes, and 405 does too") {
  auto settings = quick_settings();
  settings.token = "swordfish";
  const Running server(settings);
  for (const auto& [path, allowed] : {std::pair<std::string, std::string>{"/healthz", "GET, HEAD, OPTIONS"},
                                      {"/v1/evaluate", "POST, OPTIONS"},
                                      {"/v1/graphs/a", "GET, HEAD, PUT, DELETE, OPTIONS"},
                                      {"*", "DELETE, GET, HEAD, OPTIONS, POST, PUT"}}) {
    CAPTURE(path);
    const auto answer = options(server.port(), path);
    REQUIRE(answer);
    CHECK(answer->status == 204);
    CHECK(answer->header("allow") == allowed);
    CHECK(answer->header("access-control-allow-methods").empty());
  }
  CHECK(post(server.port(), "/healthz", "{}")->header("allow") == "GET, HEAD, OPTIONS");
  CHECK(options(server.port(), "/nowhere")->status == 404);
}

TEST_CASE("A page of an origin that is let in may ask what it may, read answers, and send requests") {
  const Running server(letting_in({site, "http://other.example:81"}));
  const std::string from_site = "Origin: " + site + "\r\n";
  const auto asked = options(server.port(), "/v1/evaluate",
                             from_site +
                                 "Access-Control-Request-Method: POST\r\n"
                                 "Access-Control-Request-Headers: content-type\r\n");
  REQUIRE(asked->status == 204);
  CHECK(asked->header("access-control-allow-origin") == site);
  CHECK(asked->header("access-control-allow-methods") == "POST, OPTIONS");
  CHECK(asked->header("access-control-allow-headers").find("Content-Type") != std::string::npos);

  const auto answer = post(server.port(), "/v1/evaluate", toy_body({{"bytes", 3}}), from_site);
  CHECK(answer->status == 200);
  CHECK(answer->header("access-control-allow-origin") == site);
  CHECK(answer->header("access-control-expose-headers").find("ETag") != std::string::npos);
  CHECK(answer->header("cross-origin-resource-policy") == "cross-origin");
  CHECK(get(server.port(), "/nowhere", from_site)->header("access-control-allow-origin") == site);
  CHECK(get(server.port(), "/healthz", "Origin: http://other.example:81\r\n")->header("access-control-allow-origin") ==
        "http://other.example:81");
}

TEST_CASE("A page of any other origin is as before, and caches know that answers differ") {
  const Running server(letting_in({site}));
  for (const std::string origin : {"https://evil.example", "http://site.example", "https://site.example:444", "null",
                                   "https://site.example.evil.example"}) {
    CAPTURE(origin);
    const std::string header = "Origin: " + origin + "\r\n";
    CHECK(post(server.port(), "/v1/evaluate", toy_body({}), header)->code() == "foreign-origin");
    const auto answer = get(server.port(), "/healthz", header);
    CHECK(answer->header("access-control-allow-origin").empty());
    CHECK(answer->header("cross-origin-resource-policy") == "same-origin");
    CHECK(answer->header("vary").find("Origin") != std::string::npos);
    CHECK(options(server.port(), "/v1/evaluate", header)->header("access-control-allow-methods").empty());
  }
  CHECK(get(server.port(), "/healthz")->header("access-control-allow-origin").empty());
}

TEST_CASE("Pages of other sites do not make browsers load from the interface, and people may follow links") {
  const std::string loaded = "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: no-cors\r\n";
  const std::string followed = "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: navigate\r\n";
  const Running server(letting_in({site}));
  const auto refused = get(server.port(), "/v1/nodes", loaded);
  CHECK(refused->status == 403);
  CHECK(refused->code() == "foreign-origin");
  CHECK(get(server.port(), "/metrics", loaded)->status == 403);
  CHECK(get(server.port(), "/v1/nodes", followed)->status == 200);
  CHECK(get(server.port(), "/v1/nodes", loaded + "Origin: " + site + "\r\n")->status == 200);
  CHECK(get(server.port(), "/v1/nodes", loaded + "Origin: https://evil.example\r\n")->status == 403);
  for (const std::string ours : {"same-origin", "same-site", "none"}) {
    CHECK(get(server.port(), "/v1/nodes", "Sec-Fetch-Site: " + ours + "\r\n")->status == 200);
  }
  // The page itself may be come to from anywhere, as after a login elsewhere.
  for (const std::string path : {"/", "/healthz", "/docs"}) CHECK(get(server.port(), path, loaded)->status != 403);
  const Running open(letting_in({"*"}));
  CHECK(get(open.port(), "/v1/nodes", loaded)->status == 200);
}

TEST_CASE("Where all origins are let in, every answer says so") {
  const Running server(letting_in({"*"}));
  for (const std::string header : {"", "Origin: https://site.example\r\n", "Origin: null\r\n"}) {
    const auto answer = get(server.port(), "/healthz", header);
    CHECK(answer->header("access-control-allow-origin") == "*");
    CHECK(answer->header("vary").find("Origin") == std::string::npos);
  }
  CHECK(post(server.port(), "/v1/evaluate", toy_body({}), "Origin: null\r\n")->status == 200);
}

TEST_CASE("Without origins that are let in, no answer speaks of other origins") {
  const Running server;
  const auto answer = get(server.port(), "/healthz", "Origin: https://site.example\r\n");
  CHECK(answer->header("access-control-allow-origin").empty());
  CHECK(answer->header("vary").find("Origin") == std::string::npos);
}

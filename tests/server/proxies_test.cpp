// Below a path, and behind proxies.

#include "server/base_path.h"
#include "server/network.h"
#include "tests/server/fixture.h"

using namespace dini;
using namespace dini::support;

namespace {

server::Settings below(const std::string& base) {
  auto settings = quick_settings();
  settings.base_path = base;
  return settings;
}

/// Settings of a server whose proxy has that address.
server::Settings behind(const std::string& proxy) {
  auto settings = quick_settings();
  settings.allowed_hosts = {"site.example"};
  settings.trusted_proxies = {*server::Network::parse(proxy)};
  return settings;
}

int status_from(int port, const std::string& host, const std::string& headers = "",
                const std::string& path = "/version") {
  return ask(port, "GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\n" + headers + "\r\n")->status;
}

/// The status of a POST from a page of that origin.
int posted_from(int port, const std::string& host, const std::string& origin, const std::string& headers = "") {
  const std::string body = toy_body({{"bytes", 1}});
  return ask(port, "POST /v1/evaluate HTTP/1.1\r\nHost: " + host + "\r\nOrigin: " + origin +
                       "\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) + "\r\n" +
                       headers + "\r\n" + body)
      ->status;
}

}  // namespace

TEST_CASE("Below a base path everything is answered, and beside it nothing but probes") {
  const Running server(below("/tools/dini"));
  for (const std::string path : {"/version", "/v1/nodes", "/openapi.json", "/docs", "/docs/style.css", "/healthz",
                                 "/problems/busy", "/v1/examples"}) {
    CAPTURE(path);
    CHECK(get(server.port(), "/tools/dini" + path)->status == 200);
    if (path == "/healthz") continue;
    const auto beside = get(server.port(), path);
    CHECK(beside->status == 404);
    CHECK(beside->json()["detail"].get<std::string>().find("/tools/dini/") != std::string::npos);
  }
  CHECK(get(server.port(), "/healthz")->status == 200);
  CHECK(get(server.port(), "/readyz")->status == 200);
  CHECK(get(server.port(), "/tools/dinitrue/version")->status == 404);
  CHECK(get(server.port(), "/tools/dini//version")->status == 404);
  CHECK(get(server.port(), "/tools/dini/%2e%2e/version")->status == 404);
  CHECK(post(server.port(), "/tools/dini/v1/evaluate", toy_body({{"bytes", 3}}))->status == 200);
  CHECK(ask(server.port(), "OPTIONS * HTTP/1.1\r\nHost: localhost\r\n\r\n")->status == 204);
}

TEST_CASE("Addresses in answers begin with the base path") {
  const Running server(below("/dini"));
  CHECK(get(server.port(), "/dini/openapi.json")->json()["servers"][0]["url"] == "/dini");
  CHECK(get(server.port(), "/dini/nowhere")->json()["type"] == "/dini/problems/not-found");
  CHECK(get(server.port(), "/nowhere")->json()["type"] == "/dini/problems/not-found");
  const auto base = get(server.port(), "/dini?a=1");
  CHECK(base->status == 308);
  CHECK(base->header("location") == "/dini/?a=1");
  CHECK(get(server.port(), "/dini/version/")->header("location") == "/dini/version");
}

TEST_CASE("The log tells the route of an address below the base path") {
  Running server(below("/dini"));
  CHECK(get(server.port(), "/dini/v1/nodes")->status == 200);
  CHECK(get(server.port(), "/v1/nodes")->status == 404);
  server.stop();
  CHECK(server.log().find("/dini/v1/nodes 200") != std::string::npos);
  CHECK(server.log().find("route=/v1/nodes") != std::string::npos);
  CHECK(server.log().find("route=other") != std::string::npos);
}

TEST_CASE("A token is needed below the base path as it is without one") {
  auto settings = below("/dini");
  settings.token = "swordfish";
  const Running server(settings);
  CHECK(get(server.port(), "/dini/v1/nodes")->status == 401);
  CHECK(get(server.port(), "/dini/v1/nodes/")->status == 401);
  CHECK(get(server.port(), "/dini/metrics")->status == 401);
  CHECK(get(server.port(), "/dini/v1/nodes", "Authorization: bEaReR swordfish\r\n")->status == 200);
}

TEST_CASE("A base path is one that cannot be misunderstood") {
  for (const char* good : {"", "/dini", "/a/b-c/d_e.f~1"}) CHECK(server::fault_in_base_path(good).empty());
  for (const char* bad : {"/", "dini", "/dini/", "//dini", "/a//b", "/a/../b", "/a%20b", "/a b", "/a?b", "/ä"}) {
    CAPTURE(bad);
    CHECK_FALSE(server::fault_in_base_path(bad).empty());
  }
}

TEST_CASE("An address with a slash too many leads to the one without, for every method, with its query") {
  const Running server;
  const auto got = get(server.port(), "/v1/examples/?a=1&b=%2F");
  CHECK(got->status == 308);
  CHECK(got->header("location") == "/v1/examples?a=1&b=%2F");
  CHECK(got->body.empty());
  CHECK(get(server.port(), "//")->header("location") == "/");
  CHECK(post(server.port(), "/v1/evaluate/", toy_body({}))->header("location") == "/v1/evaluate");
  CHECK(ask(server.port(), "HEAD /version/ HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")->status == 308);
  CHECK(get(server.port(), "/problems/a%22%20b/")->header("location") == "/problems/a%22%20b");
  for (const char* path : {"/nowhere/", "//evil.example/", "/version//"}) {
    CAPTURE(path);
    CHECK(get(server.port(), path)->status == 404);
  }
  CHECK(get(server.port(), "/v1/examples/", "Host: evil.example\r\n")->status >= 400);
}

TEST_CASE("A trusted proxy tells the name, the scheme and the client, and nobody else does") {
  const std::string forwarded =
      "X-Forwarded-Host: site.example\r\nX-Forwarded-Proto: https\r\nX-Forwarded-For: 6.6.6.6\r\n";
  {
    Running server(behind("127.0.0.0/8"));
    CHECK(status_from(server.port(), "backend:8080", forwarded) == 200);
    CHECK(status_from(server.port(), "localhost", "X-Forwarded-Host: evil.example\r\n") == 421);
    CHECK(posted_from(server.port(), "backend", "https://site.example", forwarded) == 200);
    // The scheme is part of an origin once it is known.
    CHECK(posted_from(server.port(), "backend", "http://site.example", forwarded) == 403);
    server.stop();
    CHECK(server.log().find("client=6.6.6.6") != std::string::npos);
  }
  {
    Running server(behind("10.0.0.0/8"));
    CHECK(status_from(server.port(), "backend:8080", forwarded) == 421);
    CHECK(status_from(server.port(), "localhost", "X-Forwarded-Host: evil.example\r\n") == 200);
    CHECK(posted_from(server.port(), "localhost", "https://evil.example",
                      "X-Forwarded-Host: evil.example\r\nX-Forwarded-Proto: https\r\n") == 403);
    server.stop();
    CHECK(server.log().find("client=127.0.0.1") != std::string::npos);
    CHECK(server.log().find("6.6.6.6") == std::string::npos);
  }
}

TEST_CASE("Of several forwarders the one before the trusted ones is the client") {
  auto settings = behind("127.0.0.1");
  settings.trusted_proxies.push_back(*server::Network::parse("10.0.0.0/8"));
  const auto client_of = [&](const std::string& list) {
    Running server(settings);
    CHECK(get(server.port(), "/healthz", list)->status == 200);
    server.stop();
    const std::string log = server.log();
    const auto at = log.find("client=");
    return at == std::string::npos ? "" : log.substr(at + 7, log.find_first_of(" \n", at) - at - 7);
  };
  CHECK(client_of("X-Forwarded-For: 6.6.6.6, 7.7.7.7, 10.1.2.3\r\n") == "7.7.7.7");
  CHECK(client_of("X-Forwarded-For: 6.6.6.6\r\nX-Forwarded-For: 7.7.7.7, 10.1.2.3\r\n") == "7.7.7.7");
  CHECK(client_of("X-Forwarded-For: [2001:db8::1]:4711\r\n") == "2001:db8::1");
  CHECK(client_of("X-Forwarded-For: 7.7.7.7:4711\r\n") == "7.7.7.7");
  CHECK(client_of("X-Forwarded-For: \"quoted\", ,\r\n") == "127.0.0.1");
}

TEST_CASE("Networks have the addresses that begin as they do") {
  const auto has = [](const char* network, const char* address) {
    return server::Network::parse(network)->contains(*server::Address::parse(address));
  };
  CHECK(has("10.0.0.0/8", "10.255.1.2"));
  CHECK_FALSE(has("10.0.0.0/8", "11.0.0.1"));
  CHECK(has("192.168.4.0/22", "192.168.7.255"));
  CHECK_FALSE(has("192.168.4.0/22", "192.168.8.0"));
  CHECK(has("127.0.0.1", "::ffff:127.0.0.1"));
  CHECK(has("fd00::/8", "fdab::1"));
  CHECK_FALSE(has("fd00::/8", "10.0.0.1"));
  CHECK(has("0.0.0.0/0", "8.8.8.8"));
  CHECK_FALSE(has("0.0.0.0/0", "2001:db8::1"));
  CHECK(has("::/0", "8.8.8.8"));
  for (const char* wrong : {"", "10", "10.0.0.0/", "10.0.0.0/33", "::1/129", "10.0.0.0/-1", "10.0.0.0/8/8", "name"}) {
    CAPTURE(wrong);
    CHECK_FALSE(server::Network::parse(wrong));
  }
}

TEST_CASE("A name of --allow-host with a port is let in with that port only, and without one with any") {
  auto settings = quick_settings();
  settings.allowed_hosts = {"site.example:8443", "any.example"};
  const Running server(settings);
  CHECK(status_from(server.port(), "site.example:8443") == 200);
  CHECK(status_from(server.port(), "SITE.example:8443") == 200);
  for (const char* host : {"site.example", "site.example:443", "site.example:84430", "site.example:"}) {
    CAPTURE(host);
    CHECK(status_from(server.port(), host) == 421);
  }
  CHECK(status_from(server.port(), "any.example") == 200);
  CHECK(status_from(server.port(), "any.example:1234") == 200);
}

TEST_CASE("A port that the scheme has anyway makes no other origin") {
  auto settings = quick_settings();
  settings.allowed_hosts = {"site.example:443"};
  const Running server(settings);
  CHECK(posted_from(server.port(), "site.example:443", "https://site.example") == 200);
  CHECK(posted_from(server.port(), "site.example:443", "https://site.example:443") == 200);
  CHECK(posted_from(server.port(), "site.example:443", "https://site.example:444") == 403);
  CHECK(posted_from(server.port(), "site.example:443", "http://site.example") == 403);
}

TEST_CASE("Probes of HTTP/1.0 without a name are answered") {
  auto settings = quick_settings();
  settings.token = "swordfish";
  const Running server(settings);
  for (const std::string path : {"/healthz", "/readyz"}) {
    CHECK(ask(server.port(), "GET " + path + " HTTP/1.0\r\n\r\n")->status == 200);
    CHECK(ask(server.port(), "GET " + path + " HTTP/1.0\r\nHost: 10.9.8.7\r\n\r\n")->status == 200);
  }
}

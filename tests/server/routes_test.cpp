#include "server/routes.h"

#include "tests/server/fixture.h"

using namespace dini;
using namespace dini::support;

namespace {

std::optional<Answer> get_as(int port, const std::string& path, const std::string& host) {
  return ask(port, "GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\n\r\n");
}

}  // namespace

TEST_CASE("The server says that it is well, what it is, and what its limits are") {
  const Running server;
  CHECK(get(server.port(), "/healthz")->json() == Json{{"status", "ok"}});
  CHECK(get(server.port(), "/healthz?really?")->status == 200);
  const Json version = get(server.port(), "/version")->json();
  CHECK(version["engine"] == "0.0.0-toy");
  CHECK(version["limits"]["body_bytes"] == 1 << 20);
}

TEST_CASE("The catalogue has a tag, and HEAD gives its headers alone") {
  const Running server;
  const auto answer = get(server.port(), "/v1/nodes");
  REQUIRE(answer);
  CHECK(answer->json()["nodes"][0]["id"] == "toy");
  CHECK(get(server.port(), "/v1/nodes", "If-None-Match: " + answer->header("etag") + "\r\n")->status == 304);
  Client client(server.port());
  client.send("HEAD /v1/nodes HTTP/1.1\r\nHost: localhost\r\n\r\n");
  const auto head = client.receive(true);
  REQUIRE(head);
  CHECK(head->header("content-length") == std::to_string(answer->body.size()));
  client.send("GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n");
  CHECK(client.receive()->status == 200);
}

TEST_CASE("The schema of documents has every node of the catalogue, and a tag") {
  const Running server;
  const auto answer = get(server.port(), "/schema/graph-1.json");
  REQUIRE(answer);
  CHECK(answer->status == 200);
  CHECK(answer->header("content-type") == "application/schema+json");
  CHECK(answer->json()["$schema"] == "https://json-schema.org/draft/2020-12/schema");
  CHECK(answer->json()["$defs"]["node_toy"]["properties"]["type"] == Json{{"const", "toy"}});
  CHECK(get(server.port(), "/schema/graph-1.json", "If-None-Match: " + answer->header("etag") + "\r\n")->status == 304);
}

TEST_CASE("A name in a query that is not known is refused at every address, but for pages and models") {
  const Running server;
  for (const dini::server::Route& route : dini::server::routes()) {
    std::string path(route.path);
    while (path.find('{') != std::string::npos) path.replace(path.find('{'), path.find('}') - path.find('{') + 1, "x");
    const std::string method(route.method);
    CAPTURE(method, path);
    const auto answer = ask(server.port(), method + " " + path + "?nothing=1 HTTP/1.1\r\nHost: localhost\r\n" +
                                               (method == "POST" || method == "PUT" ? "Content-Length: 0\r\n" : "") +
                                               "Connection: close\r\n\r\n");
    REQUIRE(answer);
    if (route.describe().takes_any_query) {
      CHECK(answer->code() != "unknown-member");
      continue;
    }
    CHECK(answer->status == 422);
    CHECK(answer->code() == "unknown-member");
  }
  CHECK(get(server.port(), "/v1/graphs?limt=3")->json()["detail"].get<std::string>().find("did you mean \"limit\"") !=
        std::string::npos);
  CHECK(get(server.port(), "/v1/graphs?limit=3&limit=4")->code() == "unknown-member");
  CHECK(get(server.port(), "/healthz?&")->status == 200);
}

TEST_CASE("Validation lists problems with status 200") {
  const Running server;
  CHECK(post(server.port(), "/v1/validate", toy_body({}))->json()["valid"] == true);
  const auto answer = post(server.port(), "/v1/validate", toy_body({{"invalid", "type-mismatch"}}));
  REQUIRE(answer);
  CHECK(answer->status == 200);
  CHECK(answer->json()["errors"][0]["code"] == "type-mismatch");
}

TEST_CASE("Inspection answers the value on a wire") {
  const Running server;
  const auto answer = post(server.port(), "/v1/inspect", R"({"graph":{"nodes":{}},"node":"out","full":true})");
  REQUIRE(answer);
  CHECK(answer->json()["values"] == Json::array({1}));
  CHECK(post(server.port(), "/v1/inspect", R"({"graph":{"nodes":{}}})")->code() == "required-input-missing");
}

TEST_CASE("Only our own names are served") {
  auto settings = quick_settings();
  settings.allowed_hosts = {"dini.example"};
  const Running server(settings);
  for (const std::string host : {"localhost", "127.0.0.1:80", "[::1]:8080", "LOCALHOST:1", "dini.example"}) {
    CHECK(get_as(server.port(), "/version", host)->status == 200);
  }
  for (const std::string host : {"evil.example", "localhost.evil.example", "127.0.0.1.nip.io:80", ""}) {
    CHECK(get_as(server.port(), "/version", host)->status == 421);
  }
}

TEST_CASE("Pages from elsewhere may not post") {
  const Running server;
  for (const std::string origin :
       {"http://evil.example", "null", "http://localhost:1", "https://localhost.evil.example"}) {
    const auto answer = post(server.port(), "/v1/evaluate", toy_body({}), "Origin: " + origin + "\r\n");
    REQUIRE(answer);
    CHECK(answer->status == 403);
  }
  CHECK(post(server.port(), "/v1/evaluate", toy_body({}), "Origin: http://localhost\r\n")->status == 200);
}

TEST_CASE("With a token set, the interface needs it and the rest does not") {
  auto settings = quick_settings();
  settings.token = "swordfish";
  const Running server(settings);
  CHECK(get(server.port(), "/healthz")->status == 200);
  const auto refused = get(server.port(), "/v1/nodes");
  REQUIRE(refused);
  CHECK(refused->status == 401);
  CHECK(refused->header("www-authenticate") == "Bearer");
  CHECK(get(server.port(), "/v1/nodes", "Authorization: Bearer swordfisH\r\n")->status == 401);
  CHECK(get(server.port(), "/v1/nodes", "Authorization: Bearer swordfish\r\n")->status == 200);
}

TEST_CASE("The page is served from memory with the right types and lifetimes") {
  const Folder folder;
  folder.write("index.html", "<html>");
  folder.write("main-5ZQ2W7KD.js", "let a");
  folder.write("main-5ZQ2W7KD.js.gz", "packed");
  folder.write("draco/decoder.wasm", std::string("\0asm", 4));
  folder.write("fonts/a.woff2", "w");
  folder.write(".secret", "s");
  auto settings = quick_settings();
  settings.web = folder.path();
  const Running server(settings);

  const auto index = get(server.port(), "/");
  REQUIRE(index);
  CHECK(index->body == "<html>");
  CHECK(index->header("content-type") == "text/html; charset=utf-8");
  CHECK(index->header("cache-control") == "no-cache");
  CHECK(get(server.port(), "/", "If-None-Match: " + index->header("etag") + "\r\n")->status == 304);

  const auto script = get(server.port(), "/main-5ZQ2W7KD.js", "Accept-Encoding: gzip, br\r\n");
  REQUIRE(script);
  CHECK(script->body == "packed");
  CHECK(script->header("content-encoding") == "gzip");
  CHECK(script->header("content-type") == "text/javascript; charset=utf-8");
  CHECK(script->header("cache-control") == "public, max-age=31536000, immutable");
  CHECK(get(server.port(), "/main-5ZQ2W7KD.js")->body == "let a");

  CHECK(get(server.port(), "/draco/decoder.wasm")->header("content-type") == "application/wasm");
  CHECK(get(server.port(), "/fonts/a.woff2")->header("content-type") == "font/woff2");
  for (const std::string path : {"/.secret", "/main-5ZQ2W7KD.js.gz", "/../index.html", "/%2e%2e/index.html", "/draco",
                                 "/draco/", "//index.html", "/draco/..%2findex.html"}) {
    CAPTURE(path);
    CHECK(get(server.port(), path)->status == 404);
  }
  CHECK(post(server.port(), "/index.html", "{}")->status == 405);
}

TEST_CASE("A page with a link out of it, or without an index, is not served") {
  const Folder folder;
  const dini::toy::ToyEngine engine;
  auto settings = quick_settings();
  settings.web = folder.path();
  CHECK(dini::server::Server::start(engine, settings).problems().front().code == "io");
  folder.write("index.html", "");
  std::filesystem::create_symlink("/etc/passwd", folder.path() / "passwd.txt");
  CHECK(dini::server::Server::start(engine, settings).problems().front().code == "io");
}

TEST_CASE("Examples are listed and given, and a wrong one keeps the server from starting") {
  const Folder folder;
  folder.write("b.json", R"({"format":1,"meta":{"title":"Bee","figure":"4"},"nodes":{}})");
  folder.write("a.json", R"({"format":1,"nodes":{}})");
  folder.write("notes.txt", "not an example");
  auto settings = quick_settings();
  settings.examples = folder.path();
  {
    const Running server(settings);
    const Json examples = get(server.port(), "/v1/examples")->json()["examples"];
    REQUIRE(examples.size() == 2);
    CHECK(examples[0]["id"] == "a");
    CHECK(examples[1]["title"] == "Bee");
    CHECK(examples[1]["figure"] == "4");
    CHECK(examples[1]["graph"]["format"] == 1);
    CHECK(get(server.port(), "/v1/examples/b")->json()["meta"]["title"] == "Bee");
    CHECK(get(server.port(), "/v1/examples/c")->status == 404);
  }
  folder.write("c.json", "{");
  const dini::toy::ToyEngine engine;
  const auto failed = dini::server::Server::start(engine, settings);
  REQUIRE_FALSE(failed);
  CHECK(failed.problems().front().detail.find("c.json") != std::string::npos);
}

TEST_CASE("Pictures of examples are found where they are installed and in the source tree, and listed") {
  const Folder folder;
  folder.write("examples/ring.json", R"({"format":1,"nodes":{}})");
  folder.write("examples/bare.json", R"({"format":1,"nodes":{}})");
  folder.write("examples/secret.txt", "secret");
  auto settings = quick_settings();
  settings.examples = folder.path() / "examples";
  for (const std::string place : {"docs/images/examples", "examples/images"}) {
    folder.write(place + "/ring.png", place);
    folder.write(place + "/other.png", "no example has this name");
    std::filesystem::remove(folder.path() / place / "bare.png");
    std::filesystem::create_directory(folder.path() / place / "bare.png");
    const Running server(settings);
    const Json examples = get(server.port(), "/v1/examples")->json()["examples"];
    CHECK_FALSE(examples[0].contains("image"));
    REQUIRE(examples[1]["image"] == "images/examples/ring.png");
    const auto picture = get(server.port(), "/images/examples/ring.png");
    REQUIRE(picture);
    CHECK(picture->body == place);
    CHECK(picture->header("content-type") == "image/png");
    CHECK(picture->header("cache-control") == "no-cache");
    const std::string known = "If-None-Match: " + picture->header("etag") + "\r\n";
    CHECK(get(server.port(), "/images/examples/ring.png", known)->status == 304);
    for (const std::string name : {"", "other.png", "bare.png", "ring.json", "../ring.json", "%2e%2e/ring.json",
                                   "..%2f..%2fexamples%2fsecret.txt", "./ring.png"}) {
      CAPTURE(name);
      CHECK(get(server.port(), "/images/examples/" + name)->status == 404);
    }
    CHECK(post(server.port(), "/images/examples/ring.png", "{}")->status == 405);
  }
}

TEST_CASE("A port that is taken is a problem, not a shared port") {
  const Running server;
  auto settings = quick_settings();
  settings.port = server.port();
  const dini::toy::ToyEngine engine;
  CHECK(dini::server::Server::start(engine, settings).problems().front().code == "address");
}

// The page that other pages show in a frame, and who may.

#include "tests/server/fixture.h"
#include "tests/support/documents.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A server with a page and a graph `ball`.
struct Embedding {
  explicit Embedding(const std::vector<std::string>& origins = {}, const std::string& token = "") {
    folder.write("web/index.html", "the editor");
    folder.write("web/embed/index.html", "a model");
    auto settings = quick_settings();
    settings.web = folder.path() / "web";
    settings.allowed_origins = origins;
    settings.token = token;
    server.emplace(settings);
    const std::string graph =
        document({{"ball", make("sphere_mesh")}, {"out", make("export", {{"model", from("ball")}})}}).dump();
    ask(server->port(),
        "PUT /v1/graphs/ball HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
        "If-None-Match: *\r\nContent-Length: " +
            std::to_string(graph.size()) + "\r\n\r\n" + graph);
  }
  std::optional<Answer> page(const std::string& name, const std::string& headers = "") const {
    return get(server->port(), "/embed/" + name, headers);
  }

  Folder folder;
  std::optional<RunningReal> server;
};

/// Who may frame an answer.
std::string framers(const Answer& answer) {
  const std::string policy = answer.header("content-security-policy");
  const auto at = policy.find("frame-ancestors ");
  return at == std::string::npos ? "" : policy.substr(at + 16);
}

}  // namespace

TEST_CASE("A graph that is kept has a page for frames, and one that is not has a page that is 404") {
  const Embedding embedding;
  for (const std::string name : {"ball", "ball@1", "ball?radius=2"}) {
    CAPTURE(name);
    const auto answer = embedding.page(name);
    CHECK(answer->status == 200);
    CHECK(answer->body == "a model");
    CHECK(answer->header("content-type").starts_with("text/html"));
    CHECK(embedding.page(name, "If-None-Match: " + answer->header("etag") + "\r\n")->status == 304);
  }
  for (const std::string name : {"cube", "ball@2", "index.html", "..", "%22%3E%3Cscript%3E"}) {
    CAPTURE(name);
    const auto answer = embedding.page(name);
    CHECK(answer->status == 404);
    CHECK(answer->body == "a model");
    CHECK(answer->header("cache-control") == "no-store");
  }
  CHECK(get(embedding.server->port(), "/embed")->status == 404);
}

TEST_CASE("Only the server's own pages and those that are let in may frame it, and none may frame anything else") {
  const Embedding closed;
  CHECK(framers(*closed.page("ball")) == "'self'");
  const Embedding open({"https://site.example", "http://127.0.0.1:81"});
  CHECK(framers(*open.page("ball")) == "'self' https://site.example http://127.0.0.1:81");
  CHECK(framers(*open.page("nothing")) == "'self' https://site.example http://127.0.0.1:81");
  CHECK(open.page("ball")->header("cross-origin-resource-policy") == "cross-origin");
  CHECK(open.page("ball")->header("cross-origin-embedder-policy") == "require-corp");
  CHECK(framers(*Embedding({"*"}).page("ball")) == "'self' *");
  for (const std::string address : {"/", "/v1/graphs/ball", "/v1/graphs/ball/outputs/out.glb", "/docs"}) {
    CAPTURE(address);
    const auto answer = get(open.server->port(), address);
    CHECK(answer->status == 200);
    CHECK(framers(*answer) == "'none'");
    CHECK(answer->header("cross-origin-resource-policy") == "same-origin");
  }
}

TEST_CASE("Who has no token is not told which graphs there are") {
  const Embedding guarded({}, "swordfish");
  CHECK(guarded.page("ball")->status == 200);
  CHECK(guarded.page("nothing")->status == 200);
}

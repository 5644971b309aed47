#include "service/identity.h"

#include <catch2/catch.hpp>
#include <set>

#include "tests/support/requests.h"
#include "tests/support/shared_engine.h"

using namespace dini;
using namespace dini::support;

namespace {

Json graph() {
  Json json = document({{"ball", make("sphere_mesh", {{"radius", {{"parameter", "reach"}}}})},
                        {"ring", make("circle", {{"radius", 0.25}})},
                        {"out", make("export", {{"model", Json::array({from("ball"), from("ring")})}})}});
  json["parameters"] = {{"reach", {{"type", "number"}, {"default", 1.5}}}};
  return json;
}

Digest identity(const Asked& asked) { return identity_of(request_to(engine(), asked)); }

}  // namespace

TEST_CASE("The hash of a graph is that of its canonical form without what is noted beside it") {
  const Json plain = Json::parse(R"({"nodes": {"a": {"type": "number", "inputs": {"value": 1.5}}}, "format": 1})");
  const std::string canonical = R"({"format":1,"nodes":{"a":{"inputs":{"value":1.5},"type":"number"}}})";
  CHECK(graph_hash(plain) == sha256(canonical));
  Json noted = plain;
  noted["meta"] = {{"title", "A number"}};
  noted["ui"] = {{"a", {1, 2}}};
  noted["$schema"] = "graph-1.json";
  CHECK(graph_hash(noted) == graph_hash(plain));
  CHECK(notes_of(noted) == Json{{"$schema", "graph-1.json"}, {"meta", noted["meta"]}, {"ui", noted["ui"]}});
  CHECK(notes_of(plain) == Json::object());
  Json other = plain;
  other["nodes"]["a"]["inputs"]["value"] = 2.5;
  CHECK(graph_hash(other) != graph_hash(plain));
}

TEST_CASE("A graph is read once, however its document is spelled and whatever it notes") {
  Json noted = graph();
  noted["ui"] = {{"nodes", {{"ball", {{"x", 1}}}}}};
  const SharedGraph read = engine().read(graph());
  CHECK(engine().read(noted) == read);
  CHECK(read->held > 0);
  noted["$schema"] = 7;
  const Result<Json> verdict = engine().validate(*engine().read(noted), Json::object(), Cancel());
  CHECK((*verdict)["errors"][0]["pointer"] == "/graph/$schema");
  const Json wrong = {{"format", 3}};
  CHECK(engine().read(wrong) != engine().read(wrong));
}

TEST_CASE("What is no graph says so to whatever is asked of it") {
  const SharedGraph wrong = engine().read({{"format", 3}, {"nodes", Json::object()}});
  const Result<Json> verdict = engine().validate(*wrong, Json::object(), Cancel());
  REQUIRE(verdict);
  CHECK((*verdict)["valid"] == false);
  CHECK((*verdict)["errors"][0]["code"] == "unsupported-format");
  CHECK(engine().prepare({.graph = wrong}, Cancel()).problems().front().code == "unsupported-format");
  CHECK(engine().inspect({.graph = wrong, .node = "a"}, Job()).problems().front().code == "unsupported-format");
}

TEST_CASE("Requests of equal identity are those that ask for the same") {
  const Asked plain = {.graph = graph()};
  Asked noted = plain;
  noted.graph["meta"] = {{"title", "Ball"}};
  CHECK(identity(noted) == identity(plain));

  const auto with = [&](auto change) {
    Asked asked = plain;
    change(asked);
    return identity(asked);
  };
  const std::set<Digest> different = {
      identity(plain),
      with([](Asked& asked) { asked.graph["nodes"]["ring"]["inputs"]["radius"] = 0.5; }),
      with([](Asked& asked) {
        asked.parameters = {{"reach", 2}};
      }),
      with([](Asked& asked) { asked.output = "out"; }),
      with([](Asked& asked) { asked.quality = Quality::draft; }),
      with([](Asked& asked) { asked.triangle_budget = 0; }),
      with([](Asked& asked) { asked.preview = {"ring"}; }),
      with([](Asked& asked) {
        asked.preview = {"ring", "ball"};
      }),
      with([](Asked& asked) { asked.parts = true; }),
      with([](Asked& asked) { asked.format = "glb"; }),
      with([](Asked& asked) { asked.draco = false; }),
      with([](Asked& asked) { asked.embed_graph = true; }),
      with([](Asked& asked) {
        asked.embed_graph = true;
        asked.graph["meta"] = {{"title", "Ball"}};
      }),
  };
  CHECK(different.size() == 13);
}

TEST_CASE("A file that carries its document carries its notes too") {
  Json noted = graph();
  noted["meta"] = {{"title", "Ball"}};
  const std::string bare = file_of(engine(), {.graph = graph(), .embed_graph = true});
  const std::string full = file_of(engine(), {.graph = noted, .embed_graph = true});
  CHECK(bare.find(R"("title":"Ball")") == std::string::npos);
  CHECK(full.find(R"("title":"Ball")") != std::string::npos);
}

// Documents with groups over HTTP: evaluated, kept, and told apart.

#include "tests/server/fixture.h"
#include "tests/support/documents.h"

using namespace dini;
using namespace dini::support;

namespace {

Json grouped(double radius = 1) {
  Json graph = {
      {"format", 2},
      {"groups",
       {{"ball",
         {{"inputs", {{{"name", "radius"}}}},
          {"outputs", {{{"name", "mesh"}, {"from", "skin"}}}},
          {"nodes",
           {{"skin", make("sphere_mesh", {{"radius", {{"input", "radius"}}}, {"segments", 8}, {"rings", 4}})}}}}}}},
      {"nodes", {{"a", make("group/ball", {{"radius", radius}})}, {"out", make("export", {{"model", from("a")}})}}}};
  return graph;
}

Json flat(double radius = 1) {
  return {{"format", 2},
          {"nodes",
           {{"a/skin", make("sphere_mesh", {{"radius", radius}, {"segments", 8}, {"rings", 4}})},
            {"out", make("export", {{"model", from("a/skin")}})}}}};
}

std::optional<Answer> send(int port, const std::string& method, const std::string& path, const Json& body,
                           const std::string& headers = "") {
  const std::string text = body.dump();
  return ask(port, method + " " + path + " HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n" +
                       headers + "Content-Length: " + std::to_string(text.size()) + "\r\n\r\n" + text);
}

}  // namespace

TEST_CASE("A graph with groups is answered with the bytes and the tag of its flat form, and tells times inside") {
  const RunningReal server;
  const auto with = send(server.port(), "POST", "/v1/evaluate", {{"graph", grouped()}});
  const auto without = send(server.port(), "POST", "/v1/evaluate", {{"graph", flat()}});
  REQUIRE(with->status == 200);
  CHECK(with->body == without->body);
  CHECK(with->header("etag") == without->header("etag"));
  const auto report =
      send(server.port(), "POST", "/v1/evaluate", {{"graph", grouped()}}, "Accept: application/json\r\n");
  CHECK(report->json()["nodes"].contains("a/skin"));
  Json wrong = grouped();
  wrong["groups"]["ball"]["nodes"]["skin"]["inputs"]["rings"] = -1;
  const Json error = send(server.port(), "POST", "/v1/evaluate", {{"graph", wrong}})->json()["errors"][0];
  CHECK(error["node"] == "a/skin");
  CHECK(error["pointer"] == "/graph/groups/ball/nodes/skin/inputs/rings");
  const auto inspected = send(server.port(), "POST", "/v1/inspect", {{"graph", grouped()}, {"node", "a"}});
  CHECK(inspected->json()["type"] == "mesh");
}

TEST_CASE("A stored graph with groups comes back as it was, and its versions differ by groups") {
  const RunningReal server;
  const auto created = send(server.port(), "PUT", "/v1/graphs/balls", grouped(), "If-None-Match: *\r\n");
  REQUIRE(created->status == 201);
  CHECK(get(server.port(), "/v1/graphs/balls")->json() == grouped());
  const auto model = get(server.port(), "/v1/graphs/balls/outputs/out");
  CHECK(model->status == 200);
  Json after = grouped();
  after["groups"]["ball"]["nodes"]["skin"]["inputs"]["rings"] = 6;
  REQUIRE(
      send(server.port(), "PUT", "/v1/graphs/balls", after, "If-Match: " + created->header("etag") + "\r\n")->status ==
      200);
  const Json difference = get(server.port(), "/v1/graphs/balls/diff?from=1&to=2")->json();
  CHECK(difference["groups"]["changed"]["ball"]["nodes"]["changed"]["skin"]["inputs"]["rings"]["to"] == 6);
}

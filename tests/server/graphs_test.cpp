// Graphs that a running server keeps, and the addresses of what they make.

#include "tests/server/fixture.h"
#include "tests/support/documents.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A ball whose radius varies, under a title.
Json titled_ball(double radius = 1) {
  Json graph =
      document({{"ball", make("sphere_mesh", {{"radius", {{"parameter", "radius"}}}, {"segments", 8}, {"rings", 4}})},
                {"out", make("export", {{"model", from("ball")}})}});
  graph["parameters"] = {{"radius", {{"type", "number"}, {"default", radius}, {"min", 0}, {"max", 100}}},
                         {"quality", {{"type", "choice"}, {"default", "1"}, {"choices", {"1", "2"}}}},
                         {"axis", {{"type", "vector"}, {"default", {0, 0, 1}}}}};
  graph["meta"] = {{"title", "A ball"}};
  return graph;
}

std::optional<Answer> send(int port, const std::string& method, const std::string& path, const std::string& body = "",
                           const std::string& headers = "") {
  return ask(port, method + " " + path + " HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n" +
                       headers + "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body);
}

std::optional<Answer> create(int port, const std::string& id, const Json& graph) {
  return send(port, "PUT", "/v1/graphs/" + id, graph.dump(), "If-None-Match: *\r\n");
}

std::optional<Answer> replace(int port, const std::string& id, const Json& graph, const std::string& tag) {
  return send(port, "PUT", "/v1/graphs/" + id, graph.dump(), "If-Match: " + tag + "\r\n");
}

}  // namespace

TEST_CASE("A graph is created, read, replaced and deleted, and every version stays") {
  const RunningReal server;
  const auto created = create(server.port(), "ball", titled_ball());
  REQUIRE(created->status == 201);
  CHECK(created->header("location") == "/v1/graphs/ball");
  CHECK(created->json()["title"] == "A ball");
  const std::string tag = created->header("etag");

  const auto read = get(server.port(), "/v1/graphs/ball");
  CHECK(read->body == titled_ball().dump());
  CHECK(read->header("etag") == tag);
  CHECK(get(server.port(), "/v1/graphs/ball", "If-None-Match: " + tag + "\r\n")->status == 304);

  const auto replaced = replace(server.port(), "ball", titled_ball(2), tag);
  REQUIRE(replaced->status == 200);
  CHECK(replaced->json()["version"] == 2);
  CHECK(get(server.port(), "/v1/graphs/ball@1")->body == titled_ball().dump());
  CHECK(get(server.port(), "/v1/graphs/ball@1")->header("cache-control").find("immutable") != std::string::npos);
  CHECK(get(server.port(), "/v1/graphs/ball@2")->body == titled_ball(2).dump());
  CHECK(get(server.port(), "/v1/graphs/ball@3")->status == 404);

  CHECK(send(server.port(), "DELETE", "/v1/graphs/ball", "", "If-Match: " + tag + "\r\n")->status == 412);
  CHECK(send(server.port(), "DELETE", "/v1/graphs/ball")->status == 204);
  CHECK(send(server.port(), "DELETE", "/v1/graphs/ball")->status == 404);
  CHECK(get(server.port(), "/v1/graphs/ball")->status == 404);
  CHECK(get(server.port(), "/v1/graphs/ball@2")->status == 200);
  CHECK(get(server.port(), "/v1/graphs/ball/versions")->json()["versions"].size() == 2);
}

TEST_CASE("No write is lost to another one, and one that is sent again is answered as before") {
  const RunningReal server;
  CHECK(send(server.port(), "PUT", "/v1/graphs/ball", titled_ball().dump())->code() == "precondition-required");
  CHECK(replace(server.port(), "ball", titled_ball(), "*")->code() == "precondition-failed");
  const std::string tag = create(server.port(), "ball", titled_ball())->header("etag");
  CHECK(create(server.port(), "ball", titled_ball())->status == 200);
  CHECK(create(server.port(), "ball", titled_ball(2))->code() == "precondition-failed");
  REQUIRE(replace(server.port(), "ball", titled_ball(2), tag)->status == 200);
  CHECK(replace(server.port(), "ball", titled_ball(2), tag)->json()["version"] == 2);
  const auto late = replace(server.port(), "ball", titled_ball(3), tag);
  CHECK(late->status == 412);
  CHECK(late->header("etag") != tag);
  CHECK(replace(server.port(), "ball", titled_ball(3), late->header("etag"))->json()["version"] == 3);
}

TEST_CASE("Only documents are kept, under names that no address can mean otherwise") {
  const RunningReal server;
  for (const std::string id : {"..", "%2e%2e", "a.b", "1a", "a@1", "-", "%F0%9F%AA%91", "a%2Fb"}) {
    CAPTURE(id);
    const auto answer = create(server.port(), id, titled_ball());
    CHECK((answer->code() == "invalid-id" || answer->status == 404));
    CHECK(get(server.port(), "/v1/graphs/" + id)->status == 404);
  }
  CHECK(create(server.port(), std::string(65, 'a'), titled_ball())->code() == "invalid-id");
  CHECK(create(server.port(), "a", Json::array())->status == 422);
  CHECK(create(server.port(), "a", {{"format", 1}})->status == 422);
  CHECK(send(server.port(), "PUT", "/v1/graphs/a", "{", "If-None-Match: *\r\n")->code() == "not-json");
  CHECK(get(server.port(), "/v1/graphs")->json()["graphs"].empty());
  // What a graph lacks may be added later.
  Json unfinished = titled_ball();
  unfinished["nodes"]["out"]["inputs"]["model"] = {{"from", "nowhere"}};
  CHECK(create(server.port(), "a", unfinished)->status == 201);
}

TEST_CASE("The list has pages, and unknown words of a query are told") {
  const RunningReal server;
  for (const char* id : {"a", "b", "c"}) REQUIRE(create(server.port(), id, titled_ball())->status == 201);
  const Json page = get(server.port(), "/v1/graphs?limit=2")->json();
  CHECK(page["graphs"].size() == 2);
  CHECK(page["next"] == "b");
  CHECK(get(server.port(), "/v1/graphs?limit=2&after=b")->json()["graphs"][0]["id"] == "c");
  CHECK(get(server.port(), "/v1/graphs?query=BALL")->json()["graphs"].size() == 3);
  CHECK(get(server.port(), "/v1/graphs?query=%27")->json()["graphs"].empty());
  const auto wrong = get(server.port(), "/v1/graphs?limits=2");
  CHECK(wrong->status == 422);
  CHECK(wrong->body.find("limit") != std::string::npos);
  for (const char* limit : {"0", "1001", "-1", "x", "1.5", ""}) {
    CHECK(get(server.port(), "/v1/graphs?limit=" + std::string(limit))->code() == "out-of-range");
  }
}

TEST_CASE("A difference tells nodes, inputs and parameters that changed") {
  const RunningReal server;
  Json other = titled_ball(2);
  other["nodes"]["ball"]["inputs"]["segments"] = 9;
  other["nodes"]["more"] = make("sphere_mesh");
  other["parameters"].erase("axis");
  create(server.port(), "ball", titled_ball());
  replace(server.port(), "ball", other, "*");
  const Json difference = get(server.port(), "/v1/graphs/ball/diff")->json();
  CHECK(difference["from"] == 1);
  CHECK(difference["to"] == 2);
  CHECK(difference["nodes"]["added"] == Json{"more"});
  CHECK(difference["nodes"]["removed"].empty());
  CHECK(difference["nodes"]["changed"] == Json{{"ball", {{"inputs", {{"segments", {{"from", 8}, {"to", 9}}}}}}}});
  CHECK(difference["parameters"]["removed"] == Json{"axis"});
  CHECK(difference["parameters"]["changed"]["radius"]["default"] == Json{{"from", 1}, {"to", 2}});
  const Json back = get(server.port(), "/v1/graphs/ball/diff?from=2&to=1")->json();
  CHECK(back["nodes"]["removed"] == Json{"more"});
  CHECK(get(server.port(), "/v1/graphs/ball/diff?from=1&to=1")->json()["nodes"]["changed"].empty());
  CHECK(get(server.port(), "/v1/graphs/ball/diff?to=3")->code() == "out-of-range");
  CHECK(get(server.port(), "/v1/graphs/nothing/diff")->status == 404);
}

TEST_CASE("An output has an address with the bytes of an evaluation") {
  const RunningReal server;
  create(server.port(), "ball", titled_ball());
  const Json wanted = {{"graph", titled_ball()}, {"parameters", {{"radius", 2.5}}}};
  const auto evaluated = post(server.port(), "/v1/evaluate", wanted.dump());
  const auto answer = get(server.port(), "/v1/graphs/ball/outputs/out.glb?radius=2.5");
  REQUIRE(answer->status == 200);
  CHECK(answer->body == evaluated->body);
  CHECK(answer->header("etag") == evaluated->header("etag"));
  CHECK(answer->header("content-type") == "model/gltf-binary");
  CHECK(answer->header("cache-control") == "no-cache");
  CHECK(answer->header("content-disposition").starts_with("inline"));
  CHECK(get(server.port(), "/v1/graphs/ball@1/outputs/out?radius=2.5&download")->header("content-disposition") ==
        "attachment; filename=\"out.glb\"");
  CHECK(get(server.port(), "/v1/graphs/ball@1/outputs/out")->header("cache-control").find("immutable") !=
        std::string::npos);
  const auto part = get(server.port(), "/v1/graphs/ball/outputs/out.glb?radius=2.5", "Range: bytes=0-3\r\n");
  CHECK(part->status == 206);
  CHECK(part->body == "glTF");
  CHECK(get(server.port(), "/v1/graphs/ball/outputs/out.gltf")->header("content-type") == "model/gltf+json");
  CHECK(get(server.port(), "/v1/graphs/ball/outputs/out.glb?draco=false")->body.find("KHR_draco") == std::string::npos);
  CHECK(get(server.port(), "/v1/graphs/ball/outputs/out.glb?draco=true")->body.find("KHR_draco") != std::string::npos);
  CHECK(get(server.port(), "/v1/graphs/ball/outputs/out?accept=application/json")->json().contains("nodes"));
  CHECK(get(server.port(), "/v1/graphs/ball/outputs/out?axis=1,0,0&parameter.quality=2&quality=draft")->status == 200);
}

TEST_CASE("What a client has is answered 304 before anything is computed, on a server that knows nothing yet") {
  std::string tag;
  const Folder folder;
  auto settings = quick_settings();
  settings.data = folder.path() / "data";
  {
    const RunningReal server(settings);
    create(server.port(), "ball", titled_ball());
    tag = get(server.port(), "/v1/graphs/ball/outputs/out.glb?radius=3")->header("etag");
  }
  const RunningReal server(settings);
  const auto answer = get(server.port(), "/v1/graphs/ball/outputs/out.glb?radius=3", "If-None-Match: " + tag + "\r\n");
  CHECK(answer->status == 304);
  CHECK(answer->header("server-timing").find("evaluate") == std::string::npos);
}

TEST_CASE("What is wrong with an address of an output is told with what would be right") {
  const RunningReal server;
  create(server.port(), "ball", titled_ball());
  const auto problem = [&](const std::string& address) {
    const auto answer = get(server.port(), "/v1/graphs/" + address);
    return std::pair(answer->code(), answer->json()["detail"].get<std::string>());
  };
  CHECK(problem("ball/outputs/out?radios=2").first == "unknown-parameter");
  CHECK(problem("ball/outputs/out?radios=2").second.find("radius") != std::string::npos);
  CHECK(problem("ball/outputs/out?radius=1&radius=2").first == "unknown-member");
  CHECK(problem("ball/outputs/out?radius=big").first == "type-mismatch");
  CHECK(problem("ball/outputs/out?radius=101").first == "out-of-range");
  CHECK(problem("ball/outputs/out?quality=best").first == "not-in-choices");
  CHECK(problem("ball/outputs/out?draco=no").first == "not-in-choices");
  CHECK(problem("ball/outputs/out?format=glbb").second.starts_with("there is no format 'glbb' among glb, gltf, "));
  CHECK(problem("ball/outputs/aut").first == "unknown-output");
  CHECK(problem("ball/outputs/out.step").first == "not-found");
  CHECK(problem("bell/outputs/out").first == "not-found");
  CHECK(problem("ball/outputs/out?accept=text/html").first == "not-acceptable");
}

TEST_CASE("Words of SQL are kept and found as they are, and do nothing") {
  const RunningReal server;
  const std::vector<std::string> titles = {
      "'; DROP TABLE graphs; --", "%", "_", "a\\b", "\"quoted\"", "100 % _sure_", "'"};
  for (std::size_t i = 0; i < titles.size(); ++i) {
    Json graph = titled_ball();
    graph["meta"] = {{"title", titles[i]}, {"note", titles[titles.size() - 1 - i]}};
    const std::string id = "g" + std::to_string(i);
    REQUIRE(create(server.port(), id, graph)->status == 201);
    const Json kept = get(server.port(), "/v1/graphs/" + id)->json();
    CHECK(kept == graph);
  }
  const auto found = [&](const std::string& encoded) {
    std::vector<std::string> ids;
    const Json page = get(server.port(), "/v1/graphs?query=" + encoded)->json();
    for (const Json& graph : page["graphs"]) ids.push_back(graph["id"]);
    return ids;
  };
  CHECK(found("%25") == std::vector<std::string>{"g1", "g5"});
  CHECK(found("_") == std::vector<std::string>{"g2", "g5"});
  CHECK(found("%27") == std::vector<std::string>{"g0", "g6"});
  CHECK(found("%27%3B%20DROP") == std::vector<std::string>{"g0"});
  CHECK(found("%5C") == std::vector<std::string>{"g3"});
  CHECK(found("%22") == std::vector<std::string>{"g4"});
  CHECK(get(server.port(), "/v1/graphs?after=%27%20OR%201%3D1")->status == 200);
  CHECK(get(server.port(), "/v1/graphs")->json()["graphs"].size() == titles.size());
}

TEST_CASE("A request may name a graph that is kept instead of bringing one") {
  const RunningReal server;
  const std::string tag = create(server.port(), "ball", titled_ball())->header("etag");
  const auto ask_for = [&](const std::string& path, const Json& graph, Json more = Json::object(),
                           const std::string& headers = "") {
    more["graph"] = graph;
    return post(server.port(), path, more.dump(), headers);
  };
  const auto first = ask_for("/v1/evaluate", "ball");
  CHECK(first->status == 200);
  CHECK(first->body == ask_for("/v1/evaluate", titled_ball())->body);
  CHECK(ask_for("/v1/evaluate", "ball", {{"parameters", {{"radius", 7}}}})->body ==
        ask_for("/v1/evaluate", titled_ball(), {{"parameters", {{"radius", 7}}}})->body);

  // The name means the current version each time, the number one version for ever.
  CHECK(replace(server.port(), "ball", titled_ball(2), tag)->status == 200);
  CHECK(ask_for("/v1/evaluate", "ball")->body == ask_for("/v1/evaluate", titled_ball(2))->body);
  CHECK(ask_for("/v1/evaluate", "ball@1")->body == first->body);
  CHECK(ask_for("/v1/sweeps", "ball", {{"list", {Json::object()}}})->lines()[0]["model"]["sha256"] ==
        ask_for("/v1/sweeps", titled_ball(2), {{"list", {Json::object()}}})->lines()[0]["model"]["sha256"]);

  CHECK(ask_for("/v1/validate", "ball")->json()["valid"] == true);
  CHECK(ask_for("/v1/explain", "ball")->status == 200);
  CHECK(ask_for("/v1/inspect", "ball", {{"node", "ball"}})->status == 200);
  CHECK(ask_for("/v1/jobs", "ball@1")->status == 202);
  CHECK(ask_for("/v1/evaluate", "ball", {}, "Prefer: respond-async\r\n")->status == 202);

  for (const auto* path : {"/v1/evaluate", "/v1/validate", "/v1/explain", "/v1/inspect", "/v1/sweeps", "/v1/jobs"}) {
    for (const auto* name : {"bell", "ball@3", "ball@0", "../ball", ""}) {
      CAPTURE(path, name);
      const auto answer = ask_for(path, name);
      CHECK(answer->status == 422);
      CHECK(answer->code() == "unknown-graph");
      CHECK(answer->json()["errors"][0]["pointer"] == "/graph");
    }
  }
  CHECK(ask_for("/v1/evaluate", 3)->code() == "type-mismatch");
}

TEST_CASE("The interface of a graph is a schema of its parameters") {
  const RunningReal server;
  create(server.port(), "ball", titled_ball());
  const Json interface = get(server.port(), "/v1/graphs/ball/interface")->json();
  CHECK(interface["outputs"] == Json{"out"});
  CHECK(interface["parameters"]["properties"]["radius"] ==
        Json{{"type", "number"}, {"default", 1}, {"minimum", 0}, {"maximum", 100}});
  CHECK(interface["parameters"]["properties"]["quality"]["enum"] == Json{"1", "2"});
  CHECK(interface["parameters"]["additionalProperties"] == false);
}

TEST_CASE("A server whose data folder cannot be used starts only when it may keep nothing") {
  const Folder folder;
  folder.write("file", "no folder");
  auto settings = quick_settings();
  settings.data = folder.path() / "file";
  const auto engine = make_engine();
  CHECK_FALSE(server::Server::start(*engine, settings));
  settings.needs_data = false;
  const RunningReal server(settings);
  const auto refused = create(server.port(), "ball", titled_ball());
  CHECK(refused->status == 503);
  CHECK(refused->code() == "storage-failed");
  CHECK(post(server.port(), "/v1/evaluate", Json{{"graph", titled_ball()}}.dump())->status == 200);
}

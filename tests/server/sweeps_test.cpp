// Sweeps over a running server: lines as they are made, to clients of every patience.

#include <set>

#include "gltf/glb_container.h"
#include "jobs/job_request.h"
#include "tests/server/fixture.h"
#include "tests/support/documents.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A ball whose radius varies, with its volume measured.
Json measured_ball() {
  Json graph =
      document({{"ball", make("sphere_mesh", {{"radius", {{"parameter", "radius"}}}, {"segments", 8}, {"rings", 4}})},
                {"size", make("measure", {{"model", from("ball")}})},
                {"out", make("export", {{"model", from("ball")}})}});
  graph["parameters"] = {{"radius", {{"type", "number"}, {"default", 1}, {"min", 0}, {"max", 100}}},
                         {"unused", {{"type", "integer"}, {"default", 1}}}};
  return graph;
}

/// The ball, and a box that ends to be one at a radius of 3.
Json two_outputs() {
  Json graph = measured_ball();
  graph["nodes"]["left"] = make("expression", {{"formula", "3 - x"}, {"x", {{"parameter", "radius"}}}});
  graph["nodes"]["edges"] = make("vector", {{"x", from("left")}, {"y", 1}, {"z", 1}});
  graph["nodes"]["box"] = make("box_mesh", {{"size", from("edges")}});
  graph["nodes"]["wide"] = make("export", {{"model", from("box")}});
  return graph;
}

Json radii(int count) {
  Json values = Json::array();
  for (int i = 1; i <= count; ++i) values.push_back(i);
  return values;
}

Json sweep_of(const Json& axes) {
  Json body = {{"graph", measured_ball()}};
  body.update(axes);
  return body;
}

std::optional<Answer> sweep(int port, const Json& axes, const std::string& headers = "") {
  return post(port, "/v1/sweeps", sweep_of(axes).dump(), headers);
}

}  // namespace

TEST_CASE("A sweep answers a line for every variant, with the bytes of single evaluations") {
  const RunningReal server;
  const auto answer = sweep(server.port(), {{"grid", {{"radius", radii(40)}}}, {"measures", {"size.volume"}}});
  REQUIRE(answer);
  CHECK(answer->status == 200);
  CHECK(answer->header("content-type") == "application/x-ndjson");
  const std::vector<Json> lines = answer->lines();
  REQUIRE(lines.size() == 40);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    CAPTURE(lines[i].dump());
    CHECK(lines[i]["index"] == i);
    CHECK(lines[i]["parameters"] == Json{{"radius", i + 1}});
    CHECK(lines[i]["status"] == "succeeded");
    const double radius = static_cast<double>(i + 1);
    CHECK(lines[i]["measures"]["size.volume"].get<double>() / (radius * radius * radius) ==
          Approx(lines[0]["measures"]["size.volume"].get<double>()));
    const Json single = {{"graph", measured_ball()}, {"parameters", {{"radius", i + 1}}}};
    const auto file = get(server.port(), lines[i]["model"]["address"]);
    REQUIRE(file);
    CHECK(file->body == post(server.port(), "/v1/evaluate", single.dump())->body);
    CHECK(file->body.size() == lines[i]["model"]["bytes"]);
  }
}

TEST_CASE("All variants can be had as one file, with a node for each") {
  const RunningReal server;
  const std::string accept = "Accept: model/gltf-binary\r\n";
  const Json grid = {{"grid", {{"radius", {1, 2, 3}}, {"unused", {1, 2}}}}};
  const auto answer = sweep(server.port(), grid, accept);
  REQUIRE(answer);
  REQUIRE(answer->status == 200);
  CHECK(answer->header("content-type") == "model/gltf-binary");
  const auto chunks = split_glb(answer->body);
  REQUIRE(chunks);
  const Json document = Json::parse(chunks->json);
  CHECK(document["asset"]["extras"]["variants"] == 6);
  CHECK(document["meshes"].size() == 3);  // what the variants have in common is there once
  const Json& roots = document["scenes"][0]["nodes"];
  REQUIRE(roots.size() == 6);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const Json& node = document["nodes"][roots[i].get<std::size_t>()];
    const Json parameters = {{"radius", 1 + i / 2}, {"unused", 1 + i % 2}};
    CHECK(node["name"] == "radius=" + std::to_string(1 + i / 2) + ", unused=" + std::to_string(1 + i % 2));
    CHECK(node["extras"] == Json{{"index", i}, {"parameters", parameters}});
  }
  CHECK(sweep(server.port(), grid, accept)->body == answer->body);

  const auto failed = sweep(server.port(), {{"grid", {{"radius", {1, 101, 2}}}}}, accept);
  CHECK(failed->status == 422);
  CHECK(failed->code() == "out-of-range");
  CHECK(failed->json()["detail"].get<std::string>().starts_with("variant 1: "));
  Json without = grid;
  without["models"] = false;
  CHECK(sweep(server.port(), without, accept)->code() == "nothing-to-export");
  CHECK(sweep(server.port(), grid, "Accept: image/png\r\n")->status == 406);
}

TEST_CASE("Each variant can be made in several outputs, each with its file and its status") {
  const RunningReal server;
  const Json axes = {{"graph", two_outputs()},
                     {"grid", {{"radius", {1, 2, 3}}}},
                     {"outputs", {"wide", "out"}},
                     {"measures", {"size.volume"}}};
  const auto answer = sweep(server.port(), axes);
  REQUIRE(answer->status == 200);
  const std::vector<Json> lines = answer->lines();
  REQUIRE(lines.size() == 3);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    CAPTURE(lines[i].dump());
    CHECK(lines[i]["index"] == i);
    CHECK(lines[i]["parameters"] == Json{{"radius", i + 1}});
    CHECK(lines[i]["measures"].contains("size.volume"));
    CHECK_FALSE(lines[i].contains("model"));
    CHECK(lines[i]["outputs"].size() == 2);
    // The box of the third variant would have no width, and the ball has nothing to do with it.
    for (const std::string output : {"out", "wide"}) {
      const Json& made = lines[i]["outputs"][output];
      if (i == 2 && output == "wide") {
        CHECK(made["status"] == "failed");
        CHECK(made["errors"][0]["code"] == "degenerate");
        CHECK_FALSE(made.contains("model"));
        continue;
      }
      CHECK(made["status"] == "succeeded");
      const Json single = {
          {"graph", two_outputs()}, {"parameters", {{"radius", i + 1}}}, {"output", output}, {"measures", {"size"}}};
      const auto file = get(server.port(), made["model"]["address"]);
      REQUIRE(file->status == 200);
      CHECK(file->body == post(server.port(), "/v1/evaluate", single.dump())->body);
      CHECK(file->header("etag") == "\"" + made["model"]["sha256"].get<std::string>() + "\"");
      CHECK(file->body.size() == made["model"]["bytes"]);
    }
    CHECK(lines[i]["status"] == (i == 2 ? "failed" : "succeeded"));
    CHECK(lines[i].contains("errors") == (i == 2));
  }
  CHECK(lines[2]["errors"] == lines[2]["outputs"]["wide"]["errors"]);
}

TEST_CASE("What all outputs of a variant lack is told once for the variant, and in each") {
  const RunningReal server;
  const auto answer =
      sweep(server.port(),
            {{"graph", two_outputs()}, {"list", {{{"radius", 101}}, {{"radius", 1}}}}, {"outputs", {"out", "wide"}}});
  const std::vector<Json> lines = answer->lines();
  REQUIRE(lines.size() == 2);
  CHECK(lines[0]["errors"].size() == 1);
  for (const Json& output : lines[0]["outputs"]) CHECK(output["errors"] == lines[0]["errors"]);
  CHECK(lines[1]["status"] == "succeeded");
}

TEST_CASE("Several outputs of all variants can be had as one file, below a node for each variant") {
  const RunningReal server;
  const std::string accept = "Accept: model/gltf-binary\r\n";
  Json axes = {{"graph", two_outputs()}, {"grid", {{"radius", {1, 2}}}}, {"outputs", {"out", "wide"}}};
  const auto answer = sweep(server.port(), axes, accept);
  REQUIRE(answer->status == 200);
  const Json document = Json::parse(split_glb(answer->body)->json);
  const Json& roots = document["scenes"][0]["nodes"];
  REQUIRE(roots.size() == 2);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const Json& node = document["nodes"][roots[i].get<std::size_t>()];
    CHECK(node["name"] == "radius=" + std::to_string(i + 1));
    CHECK(node["extras"]["index"] == i);
    REQUIRE(node["children"].size() == 2);
    CHECK(document["nodes"][node["children"][0].get<std::size_t>()]["name"] == "out");
    CHECK(document["nodes"][node["children"][1].get<std::size_t>()]["name"] == "wide");
  }
  axes["grid"] = {{"radius", {1, 3}}};
  const auto failed = sweep(server.port(), axes, accept);
  CHECK(failed->status == 422);
  CHECK(failed->json()["detail"].get<std::string>().starts_with("variant 1: "));
}

TEST_CASE("Outputs that cannot be made are told by their names before a sweep begins") {
  const RunningReal server;
  const auto refused = [&](const Json& outputs, const Json& more = Json::object()) {
    Json axes = {{"graph", two_outputs()}, {"grid", {{"radius", {1}}}}, {"outputs", outputs}};
    axes.update(more);
    const Json problem = sweep(server.port(), axes)->json();
    return problem["errors"];
  };
  const Json unknown = refused({"out", "wid"});
  REQUIRE(unknown.size() == 1);
  CHECK(unknown[0]["code"] == "unknown-output");
  CHECK(unknown[0]["pointer"] == "/outputs/1");
  CHECK(unknown[0]["detail"].get<std::string>().find("did you mean \"wide\"?") != std::string::npos);
  CHECK(unknown[0]["detail"].get<std::string>().find("there is out, wide") != std::string::npos);
  const Json twice = refused({"out", "wide", "out", "nothing"});
  REQUIRE(twice.size() == 2);
  CHECK(twice[0]["code"] == "out-of-range");
  CHECK(twice[0]["pointer"] == "/outputs/2");
  CHECK(twice[1]["pointer"] == "/outputs/3");
  CHECK(refused(Json::array())[0]["code"] == "required-input-missing");
  CHECK(refused({"out"}, {{"output", "wide"}})[0]["pointer"] == "/outputs");
  CHECK(refused({"out"}, {{"models", false}})[0]["pointer"] == "/outputs");
  CHECK(refused("out")[0]["code"] == "type-mismatch");
}

TEST_CASE("The cost of a sweep counts all of its outputs") {
  const auto engine = make_engine();
  const auto cost_of = [&](const Json& outputs) {
    const Json body = {{"graph", two_outputs()}, {"grid", {{"radius", {1, 2}}}}, {"outputs", outputs}};
    const auto read = jobs::read_sweep_request(body, *engine);
    REQUIRE(read);
    const auto cost = jobs::predict(*engine, std::get<jobs::SweepRequest>(read->asked), Job{});
    REQUIRE(cost);
    return **cost;
  };
  const jobs::SweepCost ball = cost_of({"out"}), box = cost_of({"wide"}), both = cost_of({"out", "wide"});
  CHECK(ball.work > 0);
  CHECK(box.work > 0);
  CHECK(both.work == ball.work + box.work);
  CHECK(both.bytes == ball.bytes + box.bytes);
}

TEST_CASE("A variant that fails has its errors in its line, and the others go on") {
  const RunningReal server;
  const auto answer =
      sweep(server.port(), {{"list", {{{"radius", 2}}, {{"radius", 101}}, {{"nothing", 1}}, {{"radius", 3}}}}});
  REQUIRE(answer);
  const std::vector<Json> lines = answer->lines();
  REQUIRE(lines.size() == 4);
  CHECK(lines[0]["status"] == "succeeded");
  CHECK(lines[1]["status"] == "failed");
  CHECK(lines[1]["errors"][0]["code"] == "out-of-range");
  CHECK(lines[2]["errors"][0]["code"] == "unknown-parameter");
  CHECK_FALSE(lines[2].contains("model"));
  CHECK(lines[3]["status"] == "succeeded");
}

TEST_CASE("Without models a sweep tells measures only") {
  const RunningReal server;
  const auto answer = sweep(server.port(), {{"zip", {{"radius", {1, 2}}, {"unused", {7, 8}}}},
                                            {"models", false},
                                            {"measures", {"size.volume", "size.area"}}});
  REQUIRE(answer);
  const std::vector<Json> lines = answer->lines();
  REQUIRE(lines.size() == 2);
  for (const Json& line : lines) {
    CHECK(line["status"] == "succeeded");
    CHECK_FALSE(line.contains("model"));
    CHECK(line["measures"].size() == 2);
  }
}

TEST_CASE("A sweep goes on where it is told to") {
  const RunningReal server;
  const Json axes = {{"grid", {{"radius", radii(6)}}}};
  Json rest = axes;
  rest["first"] = 4;
  const auto whole = sweep(server.port(), axes)->lines(), last = sweep(server.port(), rest)->lines();
  REQUIRE(last.size() == 2);
  CHECK(last[0] == whole[4]);
  CHECK(last[1] == whole[5]);
  rest["first"] = 6;
  CHECK(sweep(server.port(), rest)->lines().empty());
}

TEST_CASE("What is wrong with a whole sweep is a problem before it begins") {
  Limits limits;
  limits.sweep_work = 1'000'000;
  const RunningReal server(quick_settings(), limits);
  CHECK(sweep(server.port(), Json::object())->code() == "required-input-missing");
  CHECK(sweep(server.port(), {{"grid", {{"radius", 1}}}})->code() == "type-mismatch");
  CHECK(sweep(server.port(), {{"list", {1}}})->code() == "type-mismatch");
  const auto large = sweep(server.port(), {{"grid", {{"radius", radii(100)}, {"unused", radii(100)}}}});
  CHECK(large->code() == "limit-exceeded");
  CHECK(large->json()["detail"].get<std::string>().find("up to variant") != std::string::npos);
}

TEST_CASE("A client that reads slowly slows its sweep down and nobody else") {
  auto settings = quick_settings();
  settings.write_rate = 0;
  const Running server(settings);
  const std::size_t before = toy::counters().started;
  const Json graph = Json::parse(toy_body({{"bytes", 1}}))["graph"];
  Json texts = Json::array();
  for (int i = 0; i < 100; ++i) texts.push_back(std::string(500, 'x') + std::to_string(i));
  Json with_parameters = graph;
  with_parameters["parameters"] = {{"x", {{"type", "text"}}}, {"y", {{"type", "integer"}}}};
  Client slow(server.port());
  slow.send(
      post_text("/v1/sweeps", Json{{"graph", with_parameters}, {"grid", {{"x", texts}, {"y", radii(100)}}}}.dump()));
  REQUIRE(eventually([&] { return toy::counters().started > before; }));
  // It fills the stream and the socket, then it waits.
  std::size_t seen = 0;
  REQUIRE(
      eventually([&] { return seen == std::exchange(seen, toy::counters().started.load()) && seen > before + 10; }));
  CHECK(toy::counters().started < before + 10'000);
  CHECK(post(server.port(), "/v1/evaluate", toy_body({{"bytes", 2}}))->status == 200);
  const auto answer = slow.receive();
  REQUIRE(answer);
  CHECK(answer->lines().size() == 10'000);
}

TEST_CASE("A client that leaves ends its sweep") {
  const Running server;
  const std::size_t before = toy::counters().started;
  Json graph = Json::parse(toy_body({{"milliseconds", 20}}))["graph"];
  graph["parameters"] = {{"x", {{"type", "integer"}}}};
  Json body = {{"graph", graph}, {"grid", {{"x", radii(2'000)}}}};
  {
    Client client(server.port());
    client.send(post_text("/v1/sweeps", body.dump()));
    REQUIRE(eventually([&] { return toy::counters().started > before + 4; }));
  }
  REQUIRE(eventually([&] { return toy::counters().started == toy::counters().finished; }));
  CHECK(toy::counters().started < before + 1'000);
  CHECK(post(server.port(), "/v1/evaluate", toy_body({{"bytes", 3}}))->status == 200);
}

TEST_CASE("A sweep past its deadline ends with a line that says where to go on") {
  const Running server;
  Json graph = Json::parse(toy_body({{"milliseconds", 50}}))["graph"];
  graph["parameters"] = {{"x", {{"type", "integer"}}}};
  const Json body = {{"graph", graph}, {"grid", {{"x", radii(1'000)}}}, {"deadline_ms", 3'000}};
  const auto answer = post(server.port(), "/v1/sweeps", body.dump());
  REQUIRE(answer);
  const std::vector<Json> lines = answer->lines();
  REQUIRE(lines.size() > 1);
  CHECK(lines.back()["status"] == "stopped");
  CHECK(lines.back()["errors"][0]["code"] == "deadline");
  CHECK(lines.back()["next"] == lines.size() - 1);
}

TEST_CASE("To HTTP/1.0 a sweep ends with its connection, and HEAD has no such address") {
  const RunningReal server;
  const std::string body = sweep_of({{"grid", {{"radius", {1, 2}}}}}).dump();
  Client old(server.port());
  old.send("POST /v1/sweeps HTTP/1.0\r\nContent-Type: application/json\r\nContent-Length: " +
           std::to_string(body.size()) + "\r\n\r\n" + body);
  const std::string all = old.rest();
  CHECK(all.find("Transfer-Encoding") == std::string::npos);
  CHECK(all.find("\"index\":1") != std::string::npos);
  CHECK(all.ends_with("}\n"));
}

TEST_CASE("A file that was made can be had whole, in parts, and not twice") {
  const RunningReal server;
  const Json line = sweep(server.port(), {{"grid", {{"radius", {5}}}}})->lines().front();
  const std::string address = line["model"]["address"];
  const auto whole = get(server.port(), address);
  REQUIRE(whole);
  CHECK(whole->header("etag") == "\"" + line["model"]["sha256"].get<std::string>() + "\"");
  CHECK(whole->header("cache-control").find("immutable") != std::string::npos);
  const auto part = [&](const std::string& range) { return get(server.port(), address, "Range: " + range + "\r\n"); };
  const std::size_t size = whole->body.size();
  CHECK(part("bytes=0-3")->status == 206);
  CHECK(part("bytes=0-3")->body == "glTF");
  CHECK(part("bytes=0-3")->header("content-range") == "bytes 0-3/" + std::to_string(size));
  CHECK(part("bytes=4-")->body == whole->body.substr(4));
  CHECK(part("bytes=-4")->body == whole->body.substr(size - 4));
  CHECK(part("bytes=-999999")->body == whole->body);
  CHECK(part("bytes=2-999999")->body == whole->body.substr(2));
  CHECK(part("bytes=" + std::to_string(size) + "-")->status == 416);
  CHECK(part("bytes=-0")->status == 416);
  for (const std::string whole_file : {"bytes=3-1", "bytes=0-1,3-4", "lines=0-3", "bytes=a-b", "bytes=-", "bytes"}) {
    CAPTURE(whole_file);
    CHECK(part(whole_file)->status == 200);
    CHECK(part(whole_file)->body == whole->body);
  }
  const std::string tag = whole->header("etag");
  CHECK(get(server.port(), address, "Range: bytes=0-3\r\nIf-Range: " + tag + "\r\n")->status == 206);
  CHECK(get(server.port(), address, "Range: bytes=0-3\r\nIf-Range: \"other\"\r\n")->status == 200);
  CHECK(get(server.port(), address, "If-None-Match: " + tag + "\r\n")->status == 304);
  CHECK(get(server.port(), "/v1/artifacts/" + std::string(64, '0'))->status == 404);
  CHECK(get(server.port(), "/v1/artifacts/xyz")->status == 404);
}

// What other programs answered with success although something had failed, case by case: here each ends with its own
// exit code and status, whatever is asked for, and leaves no file behind.

#include <map>
#include <optional>

#include "tests/cli/real_program.h"
#include "tests/cli/serving.h"
#include "tests/server/client.h"
#include "tests/support/documents.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

/// Something that must fail, and as what.
struct Row {
  std::string title;
  Json graph;
  int code = 0;            ///< the exit code of the program
  std::string problem;     ///< the code that it tells
  std::string asset = {};  ///< bytes of the file that the graph calls "mesh"
};

/// A graph whose parameter `spare` changes nothing, so that it can be swept.
Json with_spare(Json nodes) {
  nodes["spared"] = make("number", {{"value", {{"parameter", "spare"}}}});
  Json graph = document(std::move(nodes));
  graph["parameters"] = {{"spare", {{"type", "number"}, {"default", 1}}}};
  return graph;
}

Json exporting(const std::string& id, Json nodes) {
  nodes["out"] = make("export", {{"model", from(id)}});
  return with_spare(std::move(nodes));
}

Json ball_node(Json radius) {
  return make("sphere_mesh", {{"radius", std::move(radius)}, {"segments", 8}, {"rings", 4}});
}

Json ball_of(const std::string& formula) {
  return exporting("moved", {{"n", make("expression", {{"formula", formula}})},
                             {"ball", ball_node(1)},
                             {"moved", make("scale", {{"shape", from("ball")}, {"factor", from("n")}})}});
}

/// So far away that all its vertices are at one place.
Json ball_at(double distance) {
  return exporting("moved", {{"ball", ball_node(1)},
                             {"moved", make("translate", {{"shape", from("ball")}, {"vector", {distance, 0, 0}}})}});
}

Json imported() { return exporting("mesh", {{"mesh", make("import", {{"asset", "mesh"}})}}); }

std::string triangle_with(const std::string& corner) { return "v 0 0 0\nv 1 0 0\nv " + corner + "\nf 1 2 3\n"; }

Json ball_that_fails_a_check() {
  return exporting("ball", {{"ball", ball_node(1)}, {"held", make("check", {{"value", 2}, {"maximum", 1}})}});
}

Json box(Json size) { return exporting("box", {{"box", make("box_mesh", {{"size", std::move(size)}})}}); }

std::vector<Row> rows() {
  return {
      // Blender: a script that raises ends with 0.
      {"a step that fails while it runs", ball_of("1 / x"), 4, "non-finite"},
      // OpenSCAD: unknown modules and variables end with 0.
      {"an unknown node", exporting("ball", {{"ball", make("sphere_mash")}}), 3, "unknown-node-type"},
      {"an unknown input", exporting("ball", {{"ball", make("sphere_mesh", {{"radios", 1}})}}), 3, "unknown-port"},
      {"an unknown variable", ball_of("q"), 3, "invalid-formula"},
      {"a link to nothing", exporting("bal", {{"ball", ball_node(1)}}), 3, "dangling-link"},
      {"an unknown parameter", exporting("ball", {{"ball", ball_node({{"parameter", "size"}})}}), 3,
       "unknown-parameter"},
      // OpenSCAD: a failed assert() ends with 0, depending on the kind of file.
      {"a check that does not hold", ball_that_fails_a_check(), 1, "check-failed"},
      // manifold-cad: a cube of negative size is an empty file that no viewer takes.
      {"a negative size", exporting("ball", {{"ball", ball_node(-1)}}), 3, "out-of-range"},
      {"a box of negative size", box({1, -1, 1}), 4, "degenerate"},
      {"a box of no size", box({0, 0, 0}), 4, "degenerate"},
      {"a negative size from a wire",
       exporting("ball", {{"n", make("expression", {{"formula", "-1"}})}, {"ball", ball_node(from("n"))}}), 4,
       "out-of-range"},
      {"a model of nothing", ball_at(1e17), 4, "nothing-to-export"},
      // gltf-transform writes numbers that are none; draco_encoder is aborted by them.
      {"a number that is none, from a formula", ball_of("0 / x"), 4, "non-finite"},
      {"an infinite number, from a formula", ball_of("exp(1000)"), 4, "non-finite"},
      {"a mesh of a vertex that is no number", imported(), 3, "invalid-asset", triangle_with("nan 1 0")},
      {"a mesh of a vertex at infinity", imported(), 3, "invalid-asset", triangle_with("inf 1 0")},
      // Draco: a vertex that is very far takes all others to the origin.
      {"a mesh of a vertex that is too far", imported(), 3, "invalid-asset", triangle_with("3e38 1 0")},
      {"a model that is too large", ball_of("1e30"), 4, "out-of-range"},
  };
}

/// Everything that a model can be asked for as.
const std::vector<std::vector<std::string>> ways = {{"-o", "m.glb"},  {"-o", "m.glb", "--no-draco"},
                                                    {"-o", "m.gltf"}, {"-o", "m.obj"},
                                                    {"-o", "m.stl"},  {"-o", "m.ply"},
                                                    {"-o", "m.3mf"},  {}};

struct Table : Folder {
  std::string at(const std::string& name) const { return (path() / name).string(); }

  /// The words of a command on this row.
  Outcome call(const std::string& command, const Row& row, std::vector<std::string> more) const {
    std::vector<std::string> words = {command, at("graph.json")};
    if (!row.asset.empty()) words.insert(words.end(), {"--asset", "mesh=" + at("mesh.obj")});
    for (std::string& word : more) words.push_back(word.starts_with("m.") ? at(word) : std::move(word));
    return run(words);
  }

  void expect_failure(const Row& row, const Outcome& outcome) const {
    CAPTURE(outcome.code, outcome.out, outcome.err);
    CHECK(outcome.code == row.code);
    CHECK(has(outcome.err, "[" + row.problem + "]"));
    for (const auto& entry : std::filesystem::directory_iterator(path())) {
      CHECK_FALSE(entry.path().filename().string().starts_with("m."));
    }
  }
};

/// The answer to a row by HTTP, with its file uploaded.
std::optional<Answer> answer_to(int port, const Row& row, const std::string& accept) {
  std::string graph = row.graph.dump();
  if (!row.asset.empty()) {
    const auto uploaded = ask(port,
                              "POST /v1/assets HTTP/1.1\r\nHost: localhost\r\nContent-Type: model/obj\r\n"
                              "Content-Length: " +
                                  std::to_string(row.asset.size()) + "\r\n\r\n" + row.asset);
    if (!uploaded || uploaded->status != 201) return uploaded;
    graph.replace(graph.find("\"asset\":\"mesh\""), std::string("\"asset\":\"mesh\"").size(),
                  "\"asset\":" + uploaded->json()["sha256"].dump());
  }
  return post(port, "/v1/evaluate", R"({"graph":)" + graph + "}", "Accept: " + accept + "\r\n");
}

}  // namespace

TEST_CASE("What fails ends with its exit code in every format and command, and leaves no file") {
  for (const Row& row : rows()) {
    CAPTURE(row.title);
    const Table table;
    table.write("graph.json", row.graph.dump());
    if (!row.asset.empty()) table.write("mesh.obj", row.asset);
    for (const auto& way : ways) {
      CAPTURE(way);
      table.expect_failure(row, table.call("eval", row, way));
    }
    const Outcome reported = table.call("eval", row, {"--report", table.at("report.json")});
    CHECK(reported.code == row.code);
    const Json report = json_in(table.at("report.json"));
    CHECK(report["succeeded"] == false);
    CHECK(report["errors"][0]["code"] == row.problem);
    table.expect_failure(row, table.call("test", row, {}));
    table.expect_failure(row, table.call("sweep", row, {"--list", "spare=1,2", "-o", "m.{spare}.glb"}));
  }
}

TEST_CASE("What fails is a problem by HTTP, whatever is accepted") {
  ServingProgram server({}, DINI_PROGRAM);
  for (const Row& row : rows()) {
    for (const std::string accept :
         {"model/gltf-binary", "model/gltf+json", "model/obj", "model/stl", "application/json"}) {
      CAPTURE(row.title, accept);
      const auto answer = answer_to(server.port(), row, accept);
      REQUIRE(answer);
      CAPTURE(answer->body);
      CHECK(answer->status == 422);
      CHECK(answer->code() == row.problem);
    }
  }
}

TEST_CASE("A name that the graph does not know ends every command with 3, whatever else is well") {
  const Table table;
  table.write("graph.json", exporting("ball", {{"ball", ball_node(1)}}).dump());
  const std::string graph = table.at("graph.json");
  for (const auto& words : std::vector<std::vector<std::string>>{{"eval", graph, "-o", table.at("m.obj")},
                                                                 {"sweep", graph, "--list", "spare=1,2"},
                                                                 {"validate", graph},
                                                                 {"inspect", graph, "ball"},
                                                                 {"explain", graph},
                                                                 {"hash", graph}}) {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"--set", "nosuch=5"});
    const Outcome outcome = run(all);
    CAPTURE(all, outcome.err);
    CHECK(outcome.code == 3);
    CHECK(has(outcome.err, "--set nosuch: "));
    CHECK(run(words).code == 0);
  }
  CHECK(run({"eval", graph, "--output", "nosuch"}).code == 3);
  ServingProgram server({}, DINI_PROGRAM);
  const Json body = {{"graph", Json::parse(contents(graph))}, {"parameters", {{"nosuch", 5}}}};
  CHECK(post(server.port(), "/v1/evaluate", body.dump())->code() == "unknown-parameter");
}

// ComfyUI answers 200 when one of several outputs is well, and drops the others.
TEST_CASE("An output that is well does not hide another that fails") {
  const Table table;
  Json graph = exporting("ball", {{"ball", ball_node(1)}, {"n", make("expression", {{"formula", "1 / x"}})}});
  graph["nodes"]["bent"] = make("scale", {{"shape", from("ball")}, {"factor", from("n")}});
  graph["nodes"]["bad"] = make("export", {{"model", from("bent")}});
  table.write("graph.json", graph.dump());
  const Outcome made = run({"eval", table.at("graph.json"), "-o", table.at("{output}.glb")});
  CHECK(made.code == 4);
  CHECK(has(made.err, "[non-finite]"));
  CHECK(std::filesystem::exists(table.at("out.glb")));
  CHECK_FALSE(std::filesystem::exists(table.at("bad.glb")));
  CHECK(run({"test", table.at("graph.json")}).code == 4);
}

// Blender exports without Draco when the library is not there, and ends with 0.
TEST_CASE("A model is compressed where that is asked for, or says that it is not") {
  const Table table;
  table.write("graph.json", exporting("ball", {{"ball", ball_node(1)}}).dump());
  const auto document_of = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"eval", table.at("graph.json"), "-o", "-", "--format", "gltf"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run(words);
    REQUIRE(outcome.code == 0);
    return Json::parse(outcome.out);
  };
  const Json packed = document_of({}), plain = document_of({"--no-draco"});
  CHECK(packed["extensionsRequired"] == Json{"KHR_draco_mesh_compression"});
  for (const Json& mesh : packed["meshes"]) {
    for (const Json& primitive : mesh["primitives"]) {
      CHECK(primitive["extensions"].contains("KHR_draco_mesh_compression"));
    }
  }
  CHECK_FALSE(has(plain.dump(), "KHR_draco_mesh_compression"));
}

// With a vertex that is none or very far gltf-transform leaves compression away, and Draco takes all others to the
// origin.
TEST_CASE("What of a mesh cannot be used is told, and the rest is what it would be alone") {
  const Table table;
  table.write("graph.json", imported().dump());
  table.write("alone.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  REQUIRE(
      run({"eval", table.at("graph.json"), "--asset", "mesh=" + table.at("alone.obj"), "-o", table.at("a.glb")}).code ==
      0);
  for (const std::string corner : {"nan 1 0", "inf 0 0", "3e38 0 0", "0 0 -3e38"}) {
    CAPTURE(corner);
    table.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv " + corner + "\nf 1 2 3\nf 1 2 4\n");
    const Outcome outcome =
        run({"eval", table.at("graph.json"), "--asset", "mesh=" + table.at("mesh.obj"), "-o", table.at("b.glb")});
    CHECK(outcome.code == 0);
    CHECK(has(outcome.err, "warning: mesh.asset: 1 face uses a vertex that is not finite or beyond 1e18"));
    CHECK(run({"diff", table.at("a.glb"), table.at("b.glb")}).code == 0);
  }
}

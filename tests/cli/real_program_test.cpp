// The program as it is installed, over the real engine.

#include "tests/cli/real_program.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include "tests/support/requests.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A file name of this test run, removed at the end.
struct TemporaryFile {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("dini-real-" + std::to_string(::getpid()) + ".glb");
  ~TemporaryFile() { std::filesystem::remove(path); }
};

/// A small graph around one node that can be made to go wrong.
std::string graph_with(const Json& node) {
  return document({{"n", node},
                   {"ball", make("sphere_mesh", {{"segments", 8}, {"rings", 4}})},
                   {"moved", make("scale", {{"shape", from("ball")}, {"factor", from("n")}})},
                   {"out", make("export", {{"model", from("moved")}})}})
      .dump();
}

}  // namespace

TEST_CASE("Eval writes the bytes of the engine, whatever the threads and instruction set") {
  const TemporaryFile file;
  const std::string path = example("fig11_patch").string();
  const Json graph = examples().at("fig11_patch");
  const std::string expected = file_of(
      *make_engine(),
      {.graph = graph, .parameters = {{"strength", 0.3}, {"rule", "paper"}}, .output = "", .quality = Quality::final});
  const Outcome outcome =
      run({"eval", path, "--set", "strength=0.3", "--set", "rule=paper", "-o", file.path.string(), "--threads", "1"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(contents(file.path) == expected);
  const Outcome streamed =
      run({"eval", "-", "--set", "strength=0.3", "--set", "rule=paper", "-o", "-", "--threads", "2"}, graph.dump());
  CHECK(streamed.code == 0);
  CHECK(streamed.out == expected);
}

TEST_CASE("A report is the engine's, beside the file") {
  const Outcome outcome = run({"eval", example("fig11_patch").string(), "--quality", "draft", "--report", "-"});
  REQUIRE(outcome.code == 0);
  const Json report = Json::parse(outcome.out);
  CHECK(report["quality"] == "draft");
  CHECK(report["output"] == "out");
  CHECK(report["nodes"]["patch"]["type"] == "patch");
  CHECK(report["model"]["sha256"].get<std::string>().size() == 64);
}

TEST_CASE("Parts are told in lines, and in the report") {
  const TemporaryFile report;
  const Json box = make("box_mesh", {{"segments", 1}});
  const std::string graph =
      document(
          {{"box", box}, {"ring", make("circle")}, {"out", make("export", {{"model", {from("box"), from("ring")}}})}})
          .dump();
  const Outcome outcome = run({"eval", "-", "--parts", "--report", report.path.string()}, graph);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.out.find("\n  box: watertight, 1 piece, 0 pairs of triangles meet, least thickness 1 m, volume ") !=
        std::string::npos);
  CHECK(outcome.out.find("\n  ring: ") != std::string::npos);
  CHECK(Json::parse(contents(report.path))["parts"][0]["watertight"] == true);
  CHECK(run({"eval", "-", "--parts", "--preview", "ring"}, graph).code == 2);
}

TEST_CASE("A preview is drawn instead of the model, also where nothing is exported") {
  const std::string graph = document({{"ring", make("circle")}, {"loose", make("boost")}}).dump();
  const Outcome drawn = run({"eval", "-", "--preview", "ring", "-o", "-"}, graph);
  CHECK(drawn.code == 0);
  CHECK(drawn.out.starts_with("glTF"));
  CHECK(run({"eval", "-", "--preview", "rong", "-o", "-"}, graph).code == 3);
  CHECK(run({"eval", "-", "--preview", "ring", "--output", "out"}, graph).code == 2);
  CHECK(run({"eval", "-", "--preview", "ring"}, graph).out.starts_with("preview: "));
  CHECK(run({"eval", "-", "--preview", "ring", "--triangle-budget", "500"}, graph).code == 3);
  CHECK(run({"eval", "-", "--preview", "ring", "--quality", "draft", "--triangle-budget", "500"}, graph).code == 0);
}

TEST_CASE("Each way to fail ends with its own exit code") {
  const auto code = [](const Json& node, std::vector<std::string> more = {}) {
    std::vector<std::string> words = {"eval", "-"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words, graph_with(node)).code;
  };
  const Json two = make("number", {{"value", 2}});
  CHECK(code(two) == 0);
  CHECK(code(make("check", {{"value", 2}, {"maximum", 1}})) == 1);
  CHECK(code(two, {"--quality", "best"}) == 2);
  CHECK(code(make("numbre")) == 3);
  CHECK(code(two, {"--set", "reach=1"}) == 3);
  CHECK(run({"eval", "-"}, "{\"format\": 1,").code == 3);
  CHECK(code(make("expression", {{"formula", "1 / x"}})) == 4);
  CHECK(code(make("expression", {{"formula", "-1"}})) == 4);
  CHECK(code(make("range", {{"count", 10'000'000}})) == 5);
  CHECK(code(two, {"-o", "/nowhere/out.glb"}) == 6);
  CHECK(run({"eval", "/nowhere/graph.json"}).code == 6);
  const Outcome unknown = run({"eval", "-", "--set", "reach=1"}, graph_with(two));
  CHECK(unknown.err.starts_with("standard input: error: --set reach: "));
}

TEST_CASE("A deadline ends an evaluation with the exit code of limits") {
  Json generators = Json::array();
  Json nodes = {{"sheet", make("grid", {{"count_u", 2000}, {"count_v", 2000}})}};
  for (int i = 0; i < 64; ++i) {
    const std::string id = "g" + std::to_string(i);
    nodes[id] = make("point_pair", {{"position", {0.1 * i, 0, 1}}});
    generators.push_back(from(id));
  }
  nodes["bent"] =
      make("warp", {{"shape", from("sheet")}, {"generators", generators}, {"power", 1.5}, {"softening", 1}});
  nodes["skin"] = make("surface", {{"shape", from("bent")}});
  nodes["out"] = make("export", {{"model", from("skin")}});
  const Outcome outcome = run({"eval", "-", "--deadline-ms", "30"}, document(nodes).dump());
  CHECK(outcome.code == 5);
  CHECK(outcome.err.ends_with(" [deadline]\n"));
}

TEST_CASE("Inspect prints what the engine shows") {
  const Outcome outcome =
      run({"inspect", example("fig04_boosted_ring").string(), "boosted.shape", "--set", "reach=0.5"});
  REQUIRE(outcome.code == 0);
  const Json shown = Json::parse(outcome.out);
  CHECK(shown["type"] == "circle");
  CHECK(shown["values"] ==
        inspected(*make_engine(), examples().at("fig04_boosted_ring"), "boosted.shape", {{"reach", 0.5}}));
  CHECK(run({"inspect", example("fig04_boosted_ring").string(), "boostd"}).code != 0);
}

TEST_CASE("Validate finds every example valid and says what a wrong graph lacks") {
  for (const auto& [id, graph] : examples()) {
    const Outcome outcome = run({"validate", example(id).string()});
    CAPTURE(id, outcome.out, outcome.err);
    CHECK(outcome.code == 0);
  }
  const Outcome wrong = run({"validate", "-"}, graph_with(make("numbre")));
  CHECK(wrong.code == 3);
  CHECK(wrong.out.empty());
  CHECK(wrong.err.starts_with("standard input:1:"));
  CHECK(wrong.err.find(": error: n: there is no node type") != std::string::npos);
}

TEST_CASE("Validate --json prints patches that mend the file they are about") {
  const std::vector<Json> broken = {
      Json::parse(graph_with(make("numbre"))),
      Json::parse(graph_with(make("number", {{"valeu", 1}}))),
      Json::parse(graph_with(make("measure", {{"model", from("bal")}}))),
      Json::parse(graph_with(make("number", {{"value", from("n")}}))),
      Json::parse(graph_with(make("sphere_mesh", {{"segments", -1}}))),
      document({{"a~b", 1}}).patch(Json::parse(R"([{"op": "replace", "path": "/nodes", "value": {}},
          {"op": "add", "path": "/parameters", "value": {"p": {"type": "number", "default": 3, "max": 2}}}])"))};
  for (const Json& graph : broken) {
    CAPTURE(graph.dump());
    const Outcome outcome = run({"validate", "--json", "-"}, graph.dump());
    CHECK(outcome.code == 3);
    const Json errors = Json::parse(outcome.out)["errors"];
    REQUIRE_FALSE(errors.empty());
    const Json error = errors[0];
    CAPTURE(error.dump());
    CHECK(error["pointer"].get<std::string>().find("/graph") == std::string::npos);
    REQUIRE(error.contains("fix"));
    const Json mended = graph.patch(error["fix"]);
    const Json left = Json::parse(run({"validate", "--json", "-"}, mended.dump()).out)["errors"];
    for (const Json& other : left) CHECK(other["code"] != error["code"]);
  }
}

TEST_CASE("What is wrong with --set has no patch, for it is in no file") {
  const std::string graph = contents(example("fig11_patch"));
  const Outcome outcome = run({"validate", "--json", "-", "--set", "strenght=1", "--set", "rule=fast"}, graph);
  CHECK(outcome.code == 3);
  const Json errors = Json::parse(outcome.out)["errors"];
  REQUIRE(errors.size() == 2);
  for (const Json& error : errors) {
    CHECK(error["pointer"].get<std::string>().starts_with("/parameters/"));
    CHECK_FALSE(error.contains("fix"));
  }
}

TEST_CASE("Docs/document.md tells the limits of a document as they are") {
  const Limits limits;
  const std::string page = contents(DINI_DOCUMENT_PAGE);
  for (const auto& [name, value] :
       std::vector<std::pair<std::string, std::size_t>>{{"body_bytes", limits.body_bytes},
                                                        {"json_depth", limits.json_depth},
                                                        {"json_values", limits.json_values},
                                                        {"string_bytes", limits.string_bytes},
                                                        {"nodes", limits.nodes},
                                                        {"links", limits.links}}) {
    CAPTURE(name, value);
    CHECK(page.find("| `" + name + "` | " + std::to_string(value) + " |") != std::string::npos);
  }
}

TEST_CASE("The catalogue of the page's tests is the one that the program prints") {
  const Outcome outcome = run({"nodes", "--json"});
  REQUIRE(outcome.code == 0);
  INFO("It is out of date; scripts/generate writes it again");
  const bool current = contents(DINI_WEB_CATALOGUE) == outcome.out;
  CHECK(current);
}

TEST_CASE("Docs/nodes.md is what the program writes about its nodes") {
  const Outcome outcome = run({"nodes", "--markdown"});
  REQUIRE(outcome.code == 0);
  INFO("docs/nodes.md is out of date; scripts/generate writes it again");
  const bool current = contents(DINI_NODES_PAGE) == outcome.out;
  CHECK(current);
}

TEST_CASE("Docs/cli.md is what the program writes about its commands") {
  const Outcome outcome = run({"describe", "--commands"});
  REQUIRE(outcome.code == 0);
  INFO("docs/cli.md is out of date; write it again with: build/dev/dini describe --commands >docs/cli.md");
  const bool current = contents(std::filesystem::path(DINI_SOURCE_DIR) / "docs/cli.md") == outcome.out;
  CHECK(current);
  CHECK(run({"describe", "--commands", "--update", "page.md"}).code == 2);
}

TEST_CASE("The help of a command shows examples") {
  for (const std::string command : {"eval", "test", "sweep", "fmt", "hash", "diff"}) {
    const Outcome outcome = run({command, "--help"});
    CHECK(outcome.code == 0);
    CHECK(has(outcome.out, "\ndini " + command + " "));
  }
}

TEST_CASE("The tables of docs/http.md are what the program writes about its interface") {
  const TemporaryFile copy;
  std::filesystem::copy_file(DINI_HTTP_PAGE, copy.path);
  const Outcome outcome = run({"describe", "--update", copy.path.string()});
  CAPTURE(outcome.err);
  REQUIRE(outcome.code == 0);
  INFO("docs/http.md is out of date; write it again with: build/dev/dini describe --update docs/http.md");
  const bool current = contents(DINI_HTTP_PAGE) == contents(copy.path);
  CHECK(current);
  CHECK(contents(copy.path).find("| `interactive_milliseconds` | 10,000 ms |") != std::string::npos);
}

TEST_CASE("A page of documentation with a part that is none, or has no end, is refused and left as it is") {
  for (const std::string page : {"<!-- generated: nonsense -->\n<!-- end -->\n", "<!-- generated: limits -->\n"}) {
    const TemporaryFile file;
    std::ofstream(file.path) << page;
    CHECK(run({"describe", "--update", file.path.string()}).code == 2);
    CHECK(contents(file.path) == page);
  }
  CHECK(run({"describe", "--update", "/nowhere/page.md"}).code == 6);
}

TEST_CASE("The interface is printed as OpenAPI, with every route of the server") {
  const Outcome outcome = run({"describe"});
  REQUIRE(outcome.code == 0);
  const Json described = Json::parse(outcome.out);
  CHECK(described["openapi"] == "3.1.0");
  CHECK(described["paths"]["/v1/evaluate"]["post"]["operationId"] == "evaluate");
  CHECK(described["paths"]["/v1/nodes"]["head"]["operationId"] == "nodesHead");
}

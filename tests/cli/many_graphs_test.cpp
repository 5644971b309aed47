// Several graphs and several outputs in one call of eval.

#include "tests/cli/real_program.h"
#include "tests/support/documents.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

Json ball(double radius) {
  return document({{"ball", make("sphere_mesh", {{"segments", 8}, {"rings", 4}, {"radius", radius}})},
                   {"out", make("export", {{"model", from("ball")}})}});
}

/// A folder with graphs that end well, and with each exit code.
struct Graphs : Folder {
  Graphs() {
    write("one.json", ball(1).dump());
    write("two.json", ball(2).dump());
    write("wrong.json", ball(-1).dump());
    write("no json.json", "{");
    Json check = ball(1);
    check["nodes"]["check"] = make("check", {{"value", 2}, {"maximum", 1}});
    write("check.json", check.dump());
    Json both = ball(1);
    both["nodes"]["second"] = make("export", {{"model", from("ball")}, {"speed", 0}});
    write("both.json", both.dump());
  }
  std::string at(const std::string& name) const { return (path() / name).string(); }
};

}  // namespace

TEST_CASE("One bad graph does not stop the others, and the worst decides the exit code") {
  const Graphs graphs;
  const Outcome outcome =
      run({"eval", graphs.at("check.json"), graphs.at("one.json"), graphs.at("wrong.json"), graphs.at("two.json"), "-o",
           graphs.at("out/{graph}.glb"), "--mkdir", "--report", graphs.at("report.json"), "--jobs", "2"});
  CAPTURE(outcome.err);
  CHECK(outcome.code == 3);
  CHECK(has(outcome.err, "check.json:1:"));
  CHECK(has(outcome.err, "wrong.json:1:"));
  CHECK(has(outcome.out, "one.json: out: "));
  CHECK(has(outcome.out, " -> " + graphs.at("out/two.glb") + "\n"));
  CHECK(contents(graphs.at("out/one.glb")).starts_with("glTF"));
  CHECK(contents(graphs.at("out/two.glb")).starts_with("glTF"));
  CHECK_FALSE(std::filesystem::exists(graphs.at("out/wrong.glb")));
  const Json report = json_in(graphs.at("report.json"));
  CHECK(report["succeeded"] == false);
  REQUIRE(report["runs"].size() == 4);
  CHECK(report["runs"][0]["errors"][0]["code"] == "check-failed");
  CHECK(report["runs"][1]["succeeded"] == true);
  CHECK(report["runs"][1]["model"]["bytes"] == std::filesystem::file_size(graphs.at("out/one.glb")));
  CHECK(report["runs"][2]["errors"][0]["file"] == graphs.at("wrong.json"));
  CHECK(report["runs"][3]["graph"] == graphs.at("two.json"));
  CHECK(run({"eval", graphs.at("one.json"), graphs.at("check.json")}).code == 1);
  CHECK(run({"eval", graphs.at("one.json"), graphs.at("no json.json"), graphs.at("check.json")}).code == 3);
  CHECK(run({"eval", graphs.at("one.json"), graphs.at("none.json"), graphs.at("wrong.json")}).code == 6);
  CHECK(run({"eval", graphs.at("one.json"), graphs.at("two.json")}).code == 0);
}

TEST_CASE("The files are those of one call for each graph") {
  const Graphs graphs;
  REQUIRE(run({"eval", graphs.at("one.json"), graphs.at("two.json"), "-o", graphs.at("{graph}.glb")}).code == 0);
  for (const std::string name : {"one", "two"}) {
    REQUIRE(run({"eval", graphs.at(name + ".json"), "-o", graphs.at("alone.glb")}).code == 0);
    CHECK(contents(graphs.at(name + ".glb")) == contents(graphs.at("alone.glb")));
  }
}

TEST_CASE("With --fail-fast nothing is begun after a failure, and said so") {
  const Graphs graphs;
  const std::vector<std::string> words = {"eval",
                                          graphs.at("wrong.json"),
                                          graphs.at("one.json"),
                                          graphs.at("two.json"),
                                          "-o",
                                          graphs.at("{graph}.glb"),
                                          "--jobs",
                                          "1",
                                          "--json"};
  std::vector<std::string> fast = words;
  fast.push_back("--fail-fast");
  const Outcome outcome = run(fast);
  CHECK(outcome.code == 3);
  CHECK_FALSE(std::filesystem::exists(graphs.at("one.glb")));
  const Json runs = Json::parse(outcome.out)["runs"];
  CHECK(runs[1]["skipped"] == true);
  CHECK(runs[2]["succeeded"] == false);
  std::vector<std::string> going = words;
  going.push_back("--keep-going");
  CHECK(run(going).code == 3);
  CHECK(std::filesystem::exists(graphs.at("two.glb")));
  fast.push_back("--keep-going");
  CHECK(run(fast).code == 2);
}

TEST_CASE("All outputs of a graph are written by a pattern, or each under its own name") {
  const Graphs graphs;
  CHECK(run({"eval", graphs.at("both.json")}).code == 3);
  CHECK(run({"eval", graphs.at("both.json"), "-o", graphs.at("{graph}.{output}.glb")}).code == 0);
  CHECK(std::filesystem::exists(graphs.at("both.out.glb")));
  CHECK(std::filesystem::exists(graphs.at("both.second.glb")));
  CHECK(run({"eval", graphs.at("both.json"), "-o", "out=" + graphs.at("a.glb"), "-o", "second=" + graphs.at("b.gltf")})
            .code == 0);
  CHECK(contents(graphs.at("a.glb")) == contents(graphs.at("both.out.glb")));
  CHECK(contents(graphs.at("b.gltf")).starts_with("{"));
  CHECK(run({"eval", graphs.at("both.json"), "-o", "second=" + graphs.at("c.glb")}).code == 0);
  CHECK(run({"eval", graphs.at("both.json"), "-o", "third=" + graphs.at("c.glb")}).code == 3);
  CHECK(run({"eval", graphs.at("both.json"), "-o", graphs.at("{output}.glb"), "--output", "second"}).code == 0);
  CHECK(std::filesystem::exists(graphs.at("second.glb")));
  CHECK_FALSE(std::filesystem::exists(graphs.at("out.glb")));
}

TEST_CASE("Names of files that do not go with the graphs are refused before anything is computed") {
  const Graphs graphs;
  const std::string one = graphs.at("one.json"), two = graphs.at("two.json");
  for (const auto& [words, said] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{one, two, "-o", graphs.at("x.glb")}, "{graph} in it stands for their names"},
           {{one, two, "-o", "out=" + graphs.at("x.glb")}, "{graph} in it stands for their names"},
           {{one, one, "-o", graphs.at("{graph}.glb")}, "would be written twice"},
           {{one, "-o", graphs.at("{grahp}.glb")}, "did you mean \"graph\"?"},
           {{one, "-o", graphs.at("a.glb"), "-o", graphs.at("b.glb")}, "NAME=FILE"},
           {{one, "-o", "out=" + graphs.at("a.glb"), "-o", graphs.at("b.glb")}, "not both"},
           {{one, "-o", "out=" + graphs.at("a.glb"), "-o", "out=" + graphs.at("b.glb")}, "twice"},
           {{one, "-o", "out=" + graphs.at("a.glb"), "--output", "out"}, "--output"},
           {{one, "-o", "out="}, "-o needs a file"},
           {{one, "-o", "-", "--json"}, "written twice"},
           {{"-", "-"}, "read once"},
           {{one, "--jobs", "0"}, "--jobs"}}) {
    std::vector<std::string> all = {"eval"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = run(all, ball(1).dump());
    CAPTURE(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(has(outcome.err, said));
    CHECK(outcome.out.empty());
  }
  CHECK_FALSE(std::filesystem::exists(graphs.at("a.glb")));
}

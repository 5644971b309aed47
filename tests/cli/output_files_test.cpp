// What is never written over, and what is made and taken away.

#include "tests/cli/real_program.h"
#include "tests/support/documents.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

std::string ball_text() {
  return document({{"ball", make("sphere_mesh", {{"segments", 8}, {"rings", 4}})},
                   {"out", make("export", {{"model", from("ball")}})}})
      .dump();
}

}  // namespace

TEST_CASE("A file of another kind, a graph and a folder are never replaced") {
  const Folder folder;
  const auto path = [&](const char* name) { return (folder.path() / name).string(); };
  folder.write("notes.txt", "remember the milk");
  folder.write("graph.json", ball_text());
  folder.write("graph.gltf", ball_text());
  folder.write("package.json", R"({"name": "a package"})");
  folder.write("folder.glb/inside", "");
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"-o", path("notes.txt")},
                                             {"-o", path("notes.txt"), "--format", "glb"},
                                             {"-o", path("graph.json"), "--format", "gltf"},
                                             {"-o", path("graph.gltf")},
                                             {"-o", ""},
                                             {"--report", ""},
                                             {"--report", path("graph.json")},
                                             {"--report", path("package.json")},
                                             {"--report", path("notes.txt")},
                                             {"-o", path("new.glb"), "--report", path("new.glb")}}) {
    std::vector<std::string> words = {"eval", "-"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run(words, ball_text());
    CAPTURE(more, outcome.err);
    CHECK(outcome.code == 2);
    CHECK(has(outcome.err, "[usage]"));
  }
  CHECK(run({"eval", "-", "-o", path("folder.glb")}, ball_text()).code == 6);
  CHECK(folder.read("notes.txt") == "remember the milk");
  CHECK(folder.read("graph.json") == ball_text());
  CHECK(folder.read("graph.gltf") == ball_text());
  CHECK(folder.read("package.json") == R"({"name": "a package"})");
}

TEST_CASE("Its own files of an earlier run are replaced, also by another format's name") {
  const Folder folder;
  const std::string model = (folder.path() / "größe 1.glb").string(), report = (folder.path() / "r").string();
  for (int times = 0; times < 2; ++times) {
    const Outcome outcome = run({"eval", "-", "-o", model, "--report", report}, ball_text());
    CAPTURE(outcome.err);
    CHECK(outcome.code == 0);
  }
  CHECK(contents(model).starts_with("glTF"));
  CHECK(json_in(report)["succeeded"] == true);
}

TEST_CASE("A report of before never survives, also when the new run does not get far") {
  const Folder folder;
  const std::string report = (folder.path() / "r.json").string();
  const auto before = [&] { folder.write("r.json", R"({"succeeded": true, "of": "an earlier run"})"); };
  before();
  CHECK(run({"eval", "-", "--report", report, "--set", "x"}, ball_text()).code == 2);
  CHECK_FALSE(std::filesystem::exists(report));
  before();
  CHECK(run({"eval", "-", "--report", report, "-o", "a.dwg"}, ball_text()).code == 2);
  CHECK_FALSE(std::filesystem::exists(report));
  before();
  CHECK(run({"eval", "/nowhere.json", "--report", report}).code == 6);
  CHECK(json_in(report)["succeeded"] == false);
  before();
  CHECK(run({"eval", "-", "--report", report, "--asset", "m=/nowhere.obj"}, ball_text()).code == 6);
  CHECK(json_in(report)["errors"][0]["code"] == "io");
}

TEST_CASE("Folders are made when that is asked for") {
  const Folder folder;
  const std::string model = (folder.path() / "a b/c/m.glb").string(), report = (folder.path() / "d/r.json").string();
  CHECK(run({"eval", "-", "-o", model}, ball_text()).code == 6);
  CHECK(run({"eval", "-", "-o", model, "--report", report, "--mkdir"}, ball_text()).code == 0);
  CHECK(std::filesystem::exists(model));
  CHECK(std::filesystem::exists(report));
  folder.write("file", "");
  CHECK(run({"eval", "-", "-o", (folder.path() / "file/m.glb").string(), "--mkdir"}, ball_text()).code == 6);
}

TEST_CASE("A mesh file comes from standard input, which is read once") {
  const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const Folder folder;
  folder.write("g.json", document({{"file", make("import", {{"asset", "m"}})},
                                   {"out", make("export", {{"model", from("file")}})}})
                             .dump());
  const std::string graph = (folder.path() / "g.json").string();
  const Outcome outcome = run({"eval", graph, "--asset", "m=-"}, mesh);
  CAPTURE(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(has(outcome.out, "1 triangles"));
  CHECK(run({"eval", graph, "--asset", "m=-", "--asset", "n=-"}, mesh).code == 2);
  CHECK(run({"eval", "-", "--asset", "m=-"}, mesh).code == 2);
  CHECK(run({"validate", "-", "--asset", "m=-"}, mesh).code == 2);
  CHECK(run({"eval", graph, "--asset", "m=-"}, "no mesh").code == 3);
}

// The commands that look at documents without evaluating them: fmt, hash, explain, upgrade.

#include <regex>

#include "tests/cli/real_program.h"
#include "tests/support/documents.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

std::vector<std::string> all_examples() {
  std::vector<std::string> files;
  for (const auto* folder : {"", "nodes"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(DINI_EXAMPLES) / folder)) {
      if (entry.path().extension() == ".json") files.push_back(entry.path().string());
    }
  }
  return files;
}

Json coarse_ball() {
  return document({{"ball", make("sphere_mesh", {{"segments", 8}, {"rings", 4}})},
                   {"out", make("export", {{"model", from("ball")}})}});
}

}  // namespace

TEST_CASE("The examples are laid out as fmt lays documents out") {
  std::vector<std::string> words = {"fmt", "--check"};
  for (const std::string& file : all_examples()) words.push_back(file);
  REQUIRE(words.size() > 50);
  const Outcome outcome = run(words);
  CHECK(outcome.code == 0);
  CHECK(outcome.out.empty());
}

TEST_CASE("Fmt changes the layout only, to one that it does not change again") {
  const Folder folder;
  Json graph = json_in(example("fig08_critical_points"));
  graph["ui"] = {{"nodes", {{"flat", {{"x", 1}, {"y", 2}}}, {"sink", {{"x", 3}, {"y", 4}}}}},
                 {"frames", Json::array()}};
  graph["nodes"]["long"] = make("list", {{"items", std::vector<int>(300, 7)}});
  const std::string pretty = graph.dump(3);
  const std::string with_mark = "\xEF\xBB\xBF" + std::regex_replace(pretty, std::regex("\n"), "\r\n");
  folder.write("short.json", graph.dump());
  folder.write("windows file.json", with_mark);
  const std::string small = (folder.path() / "short.json").string(),
                    windows = (folder.path() / "windows file.json").string();

  const Outcome check = run({"fmt", "--check", small, windows});
  CHECK(check.code == 1);
  CHECK(check.out == small + " would be laid out anew\n" + windows + " would be laid out anew\n");
  CHECK(folder.read("short.json") == graph.dump());

  CHECK(run({"fmt", small, windows}).code == 0);
  CHECK(json_in(small) == graph);
  CHECK(folder.read("short.json") == folder.read("windows file.json"));
  CHECK(run({"fmt", "--check", small, windows}).code == 0);
  CHECK(has(folder.read("short.json"), "\n      \"flat\": {\"x\": 1, \"y\": 2},\n"));
  CHECK(has(folder.read("short.json"), "\n    \"sink\": {\"type\": \"add\", \"inputs\": {"));
  CHECK(run({"fmt", "-"}, graph.dump()).out == folder.read("short.json"));
}

TEST_CASE("Fmt keeps numbers as they are spelled and puts the members in their order") {
  const std::string text = R"({"nodes": {"b": {"inputs": {"value": 1.50}, "type": "number"}, "a": {"type": "number"}},
      "ui": {"é": "\u00e9"}, "meta": {}, "format": 1})";
  CHECK(run({"fmt", "-"}, text).out == R"({
  "format": 1,
  "meta": {},
  "nodes": {
    "b": {"type": "number", "inputs": {"value": 1.50}},
    "a": {"type": "number"}
  },
  "ui": {
    "é": "\u00e9"
  }
}
)");
}

TEST_CASE("Fmt refuses what is no graph document, goes on with the others, and ends with the worst") {
  const Folder folder;
  folder.write("other.json", R"({"name": "a package"})");
  folder.write("broken.json", "{\"format\": 1,\n \"nodes\": {");
  folder.write("good.json", coarse_ball().dump());
  const auto path = [&](const char* name) { return (folder.path() / name).string(); };
  const Outcome outcome = run({"fmt", path("other.json"), path("broken.json"), path("good.json")});
  CHECK(outcome.code == 3);
  CHECK(has(outcome.err, "other.json: error: this is no graph document"));
  CHECK(has(outcome.err, "broken.json:2:12: error: the text is not JSON"));
  CHECK(folder.read("other.json") == R"({"name": "a package"})");
  CHECK(run({"fmt", "--check", path("good.json")}).code == 0);
  CHECK(run({"fmt", "/nowhere.json"}).code == 6);
  CHECK(run({"fmt"}).code == 2);
  CHECK(run({"fmt", "--chek", path("good.json")}).code == 2);
}

TEST_CASE("Hash tells the tag that an evaluation reports, and changes with what changes the file") {
  const std::string path = example("fig11_patch").string();
  const auto tags = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"hash", path, "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run(words);
    REQUIRE(outcome.code == 0);
    return Json::parse(outcome.out);
  };
  const Json usual = tags({});
  const Json report = Json::parse(run({"eval", path, "--report", "-"}).out);
  CHECK(usual["outputs"]["out"] == report["etag"]);
  CHECK(usual["engine"] == report["engine"]);
  CHECK(usual["graph"].get<std::string>().size() == 64);
  const Json other = tags({"--set", "strength=0.3"});
  CHECK(other["graph"] == usual["graph"]);
  CHECK(other["outputs"] != usual["outputs"]);
  CHECK(tags({"--format", "gltf"})["outputs"] != usual["outputs"]);
  CHECK(tags({"--quality", "draft"})["outputs"] != usual["outputs"]);
  CHECK(tags({"--output", "out"}) == usual);

  const Outcome text = run({"hash", path});
  CHECK(has(text.out, "\ngraph " + usual["graph"].get<std::string>() + "\n"));
  CHECK(has(text.out, "\nout " + usual["outputs"]["out"].get<std::string>() + "\n"));
}

TEST_CASE("Wrong calls of hash and explain end with the right code and tell nothing else") {
  const std::string path = example("fig11_patch").string();
  for (const std::string command : {"hash", "explain"}) {
    for (const auto& [more, code] :
         std::vector<std::pair<std::vector<std::string>, int>>{{{path, "--set", "strenght=1"}, 3},
                                                               {{path, "--set", "strength"}, 2},
                                                               {{path, "--output", "ot"}, 3},
                                                               {{path, "--quality", "best"}, 2},
                                                               {{path, "--asset", "a=/nowhere"}, 6},
                                                               {{"/nowhere.json"}, 6},
                                                               {{}, 2}}) {
      std::vector<std::string> words = {command};
      words.insert(words.end(), more.begin(), more.end());
      const Outcome outcome = run(words);
      CAPTURE(command, outcome.err);
      CHECK(outcome.code == code);
      CHECK(outcome.out.empty());
      CHECK(has(outcome.err, "error: "));
    }
  }
  CHECK(run({"hash", path, "--format", "dwg"}).code == 3);
  CHECK(run({"hash", "-"}, document(Json::object()).dump()).code == 3);
  CHECK(run({"explain", path, "--preview", "a", "--output", "out"}).code == 2);
}

TEST_CASE("Explain tells every node that would run, and evaluates none") {
  const Outcome outcome = run({"explain", "-"}, coarse_ball().dump());
  CHECK(outcome.code == 0);
  CHECK(outcome.out.starts_with("2 nodes run, about "));
  CHECK(has(outcome.out, "\nball  sphere_mesh  runs  "));
  const Json explained = Json::parse(run({"explain", "-", "--json", "--preview", "ball"}, coarse_ball().dump()).out);
  CHECK(explained["runs"] == 1);
  CHECK(explained["nodes"]["ball"]["why"][0]["because"] == "new");
}

TEST_CASE("Upgrade leaves formats 1 and 2 as they are, and refuses another") {
  const Outcome good = run({"upgrade", example("fig11_patch").string(), "-"}, coarse_ball().dump());
  CHECK(good.code == 0);
  CHECK(has(good.out, "fig11_patch.json: format 1 is read as it is, nothing to do\n"));
  CHECK(has(good.out, "standard input: format 1 is read as it is, nothing to do\n"));
  Json newer = coarse_ball();
  newer["format"] = 2;
  CHECK(has(run({"upgrade", "-"}, newer.dump()).out, "standard input: format 2 is the newest, nothing to do\n"));
  newer["format"] = 3;
  const Outcome other = run({"upgrade", "-"}, newer.dump());
  CHECK(other.code == 3);
  CHECK(other.out.empty());
  CHECK(has(other.err, "[unsupported-format]"));
  CHECK(run({"upgrade", "-"}, "{").code == 3);
  CHECK(run({"upgrade", "/nowhere.json"}).code == 6);
  CHECK(run({"upgrade"}).code == 2);
}

TEST_CASE("Fmt and upgrade tell as JSON what became of each file") {
  const Folder folder;
  const std::string graph = document({{"ball", make("sphere_mesh")}}).dump();
  folder.write("a.json", graph);
  const std::string path = (folder.path() / "a.json").string();
  const Outcome check = run({"fmt", "--check", "--json", path});
  CHECK(check.code == 1);
  CHECK(check.err.empty());
  CHECK(Json::parse(check.out)["files"][0]["changed"] == true);
  CHECK(Json::parse(check.out)["succeeded"] == false);
  CHECK(folder.read("a.json") == graph);
  const Json written = Json::parse(run({"fmt", "--json", path}).out);
  CHECK(written["succeeded"] == true);
  CHECK(written["files"][0] == Json{{"file", path}, {"changed", true}, {"errors", Json::array()}});
  CHECK(Json::parse(run({"fmt", "--check", "--json", path}).out)["files"][0]["changed"] == false);
  CHECK(Json::parse(run({"fmt", "--check", "--json", "-"}, graph).out)["files"][0]["file"] == "standard input");
  const Json upgraded = Json::parse(run({"upgrade", "--json", path}).out);
  CHECK(upgraded["files"][0]["format"] == 1);
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"fmt", "--json", "-"}, {"fmt", "-", "-"}, {"upgrade", "-", "-"}}) {
    const Outcome outcome = run(words, graph);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(has(outcome.err, "[usage]"));
  }
}

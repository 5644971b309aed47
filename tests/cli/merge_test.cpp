// `dini merge`, by itself and as the merge driver of git.

#include "tests/cli/real_program.h"
#include "tests/support/documents.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

const std::string base = R"({
  "format": 1,
  "parameters": {
    "reach": {"type": "number", "default": 1, "min": 0}
  },
  "nodes": {
    "ring": {"type": "circle", "inputs": {"radius": 1}},
    "ball": {"type": "sphere_mesh", "inputs": {"radius": 1, "segments": 8}},
    "out": {"type": "export", "inputs": {"model": {"from": "ball"}}}
  }
}
)";

std::string with(const std::string& text, const std::string& part, const std::string& by) {
  return std::string(text).replace(text.find(part), part.size(), by);
}

struct Sides : Folder {
  Outcome merge(const std::string& ours, const std::string& theirs, const std::vector<std::string>& more = {}) const {
    write("base.json", base);
    write("ours.json", ours);
    write("theirs.json", theirs);
    std::vector<std::string> words = {"merge", at("base.json"), at("ours.json"), at("theirs.json")};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  std::string at(const std::string& name) const { return (path() / name).string(); }
};

const std::string ours = with(base, "\"segments\": 8", "\"segments\": 16");

}  // namespace

TEST_CASE("Independent edits merge, also those of two inputs of one node") {
  const Sides sides;
  std::string theirs =
      with(base, "\"sphere_mesh\", \"inputs\": {\"radius\": 1", "\"sphere_mesh\", \"inputs\": {\"radius\": 2");
  theirs = with(theirs, "\"min\": 0", "\"min\": 0, \"max\": 4");
  theirs = with(theirs, "    \"out\"", "    \"extra\": {\"type\": \"circle\"},\n    \"out\"");
  theirs = with(theirs, "    \"ring\": {\"type\": \"circle\", \"inputs\": {\"radius\": 1}},\n", "");
  const Outcome outcome = sides.merge(ours, theirs);
  CAPTURE(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(sides.read("ours.json") == R"({
  "format": 1,
  "parameters": {
    "reach": {"type": "number", "default": 1, "min": 0, "max": 4}
  },
  "nodes": {
    "ball": {"type": "sphere_mesh", "inputs": {"radius": 2, "segments": 16}},
    "out": {"type": "export", "inputs": {"model": {"from": "ball"}}},
    "extra": {"type": "circle"}
  }
}
)");
  CHECK(sides.merge(ours, base, {"-o", "-"}).out == ours);
  CHECK(sides.read("ours.json") == ours);
  CHECK(sides.merge(base, ours, {"-o", sides.at("merged.json")}).code == 0);
  CHECK(sides.read("merged.json") == ours);
}

TEST_CASE("Edits of the same thing are conflicts that name node and input, and change nothing") {
  const Sides sides;
  for (const auto& [theirs, said] : std::vector<std::pair<std::string, std::string>>{
           {with(base, "\"segments\": 8", "\"segments\": 32"), "ball.segments: both sides changed it"},
           {with(base, "\"segments\": 8", "\"segments\": {\"parameter\": \"reach\"}"), "ball.segments: "},
           {with(base, "    \"ball\": {\"type\": \"sphere_mesh\", \"inputs\": {\"radius\": 1, \"segments\": 8}},\n",
                 ""),
            "ball: both sides changed it"}}) {
    const Outcome outcome = sides.merge(ours, theirs);
    CAPTURE(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(has(outcome.err, said));
    CHECK(has(outcome.err, "[merge-conflict]"));
    CHECK(sides.read("ours.json") == ours);
  }
}

TEST_CASE("With --json a conflict has the place in our file, and a merge says that it was one") {
  const Sides sides;
  sides.merge(ours, with(base, "\"segments\": 8", "\"segments\": 32"));
  const std::vector<std::string> words = {"merge", sides.at("base.json"), sides.at("ours.json"),
                                          sides.at("theirs.json"), "--json"};
  const Outcome conflict = run(words);
  CHECK(conflict.code == 1);
  CHECK(conflict.err.empty());
  const Json error = Json::parse(conflict.out)["errors"][0];
  CHECK(error["code"] == "merge-conflict");
  CHECK(error["node"] == "ball");
  CHECK(error["port"] == "segments");
  CHECK(error["pointer"] == "/nodes/ball/inputs/segments");
  CHECK(error["file"] == sides.at("ours.json"));
  const auto line = error["line"].get<std::size_t>(), column = error["column"].get<std::size_t>();
  std::string rest = ours;
  for (std::size_t i = 1; i < line; ++i) rest = rest.substr(rest.find('\n') + 1);
  CHECK(rest.substr(column - 1).starts_with("\"segments\""));
  sides.write("theirs.json", base);
  CHECK(Json::parse(run(words).out) == Json{{"succeeded", true}, {"errors", Json::array()}});
  std::vector<std::string> to_output = words;
  to_output.insert(to_output.end(), {"-o", "-"});
  CHECK(run(to_output).code == 2);
  CHECK(run({"merge", "-", "-", sides.at("theirs.json")}).code == 2);
}

TEST_CASE("A link to a node that the other side took away is a conflict too") {
  const Sides sides;
  const std::string uses = with(base, "\"radius\": 1, \"segments\"", "\"radius\": {\"from\": \"ring\"}, \"segments\"");
  const std::string without = with(base, "    \"ring\": {\"type\": \"circle\", \"inputs\": {\"radius\": 1}},\n", "");
  const Outcome outcome = sides.merge(uses, without);
  CHECK(outcome.code == 1);
  CHECK(has(outcome.err, "ball.radius"));
  CHECK(has(outcome.err, "[dangling-link]"));
  CHECK(sides.read("ours.json") == uses);
}

TEST_CASE("Wrong calls of merge are refused and change nothing") {
  const Sides sides;
  CHECK(sides.merge(ours, "{").code == 3);
  CHECK(has(sides.merge(ours, "{").err, "theirs.json:1:2: error: "));
  CHECK(sides.merge(ours, "{}").code == 3);
  CHECK(sides.read("ours.json") == ours);
  CHECK(run({"merge", sides.at("base.json"), sides.at("ours.json")}).code == 2);
  CHECK(run({"merge", sides.at("base.json"), sides.at("ours.json"), "/nowhere.json"}).code == 6);
}

TEST_CASE("Git merges documents by dini") {
  const Sides sides;
  const auto git = [&](const std::string& words) {
    const std::string command = "cd '" + sides.path().string() + "' && git -c user.name=a -c user.email=a@b " + words;
    return Program({"/bin/sh", "-c", command}).wait();
  };
  REQUIRE(git("init -q -b main").code == 0);
  git("config merge.dini.driver '" + std::string(DINI_PROGRAM) + " merge %O %A %B'");
  sides.write(".gitattributes", "*.json merge=dini\n");
  sides.write("graph.json", base);
  REQUIRE(git("add . && git -c user.name=a -c user.email=a@b commit -qm base").code == 0);
  git("checkout -qb theirs");
  sides.write("graph.json",
              with(base, "\"sphere_mesh\", \"inputs\": {\"radius\": 1", "\"sphere_mesh\", \"inputs\": {\"radius\": 2"));
  git("commit -qam theirs");
  git("checkout -q main");
  sides.write("graph.json", ours);
  git("commit -qam ours");
  const Outcome merged = git("merge -q --no-edit theirs");
  CAPTURE(merged.out, merged.err);
  CHECK(merged.code == 0);
  CHECK(has(sides.read("graph.json"), "{\"radius\": 2, \"segments\": 16}"));
}

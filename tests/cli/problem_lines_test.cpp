// How problems are told: with file, line and column where they have one.

#include "tests/cli/real_program.h"
#include "tests/cli/variable.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

const std::string wrong = R"({"format": 1,
 "nodes": {
  "größe": 1,
  "é": {"type": "numbre"}, "ball": {"type": "sphere_mesh", "inputs": {"radius": 1, "segments": -8}},
  "out": {"type": "export", "inputs": {"model": {"from": "ball"}}}}})";

const std::string too_small = R"({"format": 1,
 "nodes": {
  "ball": {"type": "sphere_mesh", "inputs": {"radius": 1, "segments": -8}},
  "out": {"type": "export", "inputs": {"model": {"from": "ball"}}}}})";

const std::string failing = R"({"format": 1, "nodes": {
  "n": {"type": "expression", "inputs": {"formula": "1 / x", "x": 0}},
  "ball": {"type": "sphere_mesh", "inputs": {"radius": {"from": "n"}}},
  "out": {"type": "export", "inputs": {"model": {"from": "ball"}}}}})";

}  // namespace

TEST_CASE("A problem in a file is told with its line and column, in characters") {
  const Folder folder;
  folder.write("my graph.json", wrong);
  const std::string path = (folder.path() / "my graph.json").string();
  const Outcome outcome = run({"validate", path});
  CHECK(outcome.code == 3);
  CHECK(outcome.out.empty());
  CHECK(has(outcome.err, path + ":3:3: error: "));
  CHECK(has(outcome.err, path + ":4:3: error: "));
}

TEST_CASE("Every command that reads a graph tells the same line about it") {
  const std::string line =
      "standard input:3:59: error: ball.segments: segments: got -8, accepted is 3 to 8192 [out-of-range]\n";
  CHECK(run({"validate", "-"}, too_small).err == line);
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"eval", "-"}, {"inspect", "-", "ball"}, {"hash", "-"}, {"explain", "-"}}) {
    const Outcome outcome = run(words, too_small);
    CAPTURE(words.front());
    CHECK(outcome.code == 3);
    CHECK(outcome.err == line);
  }
}

TEST_CASE("What fails only when it is computed has its place too") {
  const Outcome outcome = run({"eval", "-"}, failing);
  CHECK(outcome.code == 4);
  CHECK(outcome.err.starts_with("standard input:2:"));
  CHECK(has(outcome.err, ": error: n"));
}

TEST_CASE("A text that is no JSON is told with the place of the fault, and a byte order mark and CRLF are none") {
  CHECK(run({"validate", "-"}, "{\"format\": 1,\r\n \"nodes\": {,}}").err.starts_with("standard input:2:12: error: "));
  CHECK(run({"validate", "-"}, "\xEF\xBB\xBF{\"format\": 1,").err.starts_with("standard input:1:14: error: "));
  CHECK(run({"validate", "-"}, "").err.starts_with("standard input:1:1: error: "));
  CHECK(run({"validate", "-"}, "\xEF\xBB\xBF{\"format\": 1,\r\n\"nodes\": {}}\r\n").code == 0);
  const Outcome wide = run({"eval", "-"}, std::string("\xFF\xFE{\0", 4));
  CHECK(wide.code == 3);
  CHECK(has(wide.err, "the text is UTF-16, and documents are read in UTF-8 only [not-json]"));
}

TEST_CASE("What the text of a document says twice, or must not say, is told with its place, whatever comes after it") {
  std::string deep;
  for (int level = 0; level < 40; ++level) deep += "[";
  for (const auto& [text, place] : std::vector<std::pair<std::string, std::string>>{
           {"{\"format\": 1,\n \"nodes\": {\"a\": 1,\n  \"ä\": 2, \"a\": 3}, oops", "3:11"},
           {"{\"format\": 1, \"say \\\"a\": 1,\n\"say \\\"a\": 1}", "2:1"},
           {"\xEF\xBB\xBF{\"a\": 1, \"a\": 2}", "1:10"},
           {"{\"a\\u0001\": 1}", "1:2"},
           {"{\"a\":\n \"b\\u0000\"}", "2:2"},
           {"{\"a\": 1e999}", "1:11"},
           {deep, "1:33"}}) {
    const Outcome outcome = run({"validate", "-"}, text);
    CAPTURE(text, outcome.err);
    CHECK(outcome.code == 3);
    CHECK(outcome.err.starts_with("standard input:" + place + ": error: "));
    CHECK(has(outcome.err, "[not-json]"));
  }
  const std::string twice = "{\"format\": 1,\n \"format\": 1}";
  CHECK(has(run({"validate", "-"}, twice).err, "the name \"format\" stands twice in one object, at line 2, column 2"));
}

TEST_CASE("Every command that takes --json tells problems as JSON, and what is wrong with the call as a line") {
  const Folder folder;
  folder.write("a.json", too_small);
  folder.write("twice.json", "{\"format\": 1,\n \"format\": 1}");
  const std::string path = (folder.path() / "a.json").string(), twice = (folder.path() / "twice.json").string();
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"validate", path},
                                                                                     {"eval", path},
                                                                                     {"inspect", path, "ball"},
                                                                                     {"hash", path},
                                                                                     {"explain", path},
                                                                                     {"validate", twice},
                                                                                     {"inspect", twice, "ball"},
                                                                                     {"hash", twice},
                                                                                     {"explain", twice},
                                                                                     {"diff", path, twice},
                                                                                     {"merge", path, path, twice}}) {
    std::vector<std::string> all = words;
    all.emplace_back("--json");
    const Outcome outcome = run(all);
    CAPTURE(all, outcome.out, outcome.err);
    CHECK(outcome.code == 3);
    CHECK(outcome.err.empty());
    const Json answer = Json::parse(outcome.out);
    CHECK(answer.value("succeeded", answer.value("valid", true)) == false);
    const Json error = answer["errors"][0];
    const bool is_twice = words.back() == twice || words[1] == twice;
    CHECK(error["file"] == (is_twice ? twice : path));
    CHECK(error["line"] == (is_twice ? 2 : 3));
    CHECK(error["column"] == (is_twice ? 2 : 59));
    if (!is_twice) CHECK(error["pointer"] == "/nodes/ball/inputs/segments");
  }
  for (const std::string command : {"fmt", "upgrade"}) {
    const Outcome outcome = run({command, path, twice, "/nowhere.json", "--json"});
    CAPTURE(command, outcome.out, outcome.err);
    CHECK(outcome.code == 6);
    CHECK(outcome.err.empty());
    const Json answer = Json::parse(outcome.out);
    CHECK(answer["succeeded"] == false);
    REQUIRE(answer["files"].size() == 3);
    CHECK(answer["files"][1]["file"] == twice);
    CHECK(answer["files"][1]["errors"][0]["line"] == 2);
    CHECK(answer["files"][2]["errors"][0]["code"] == "io");
  }
  const Outcome nowhere = run({"hash", "/nowhere.json", "--json"});
  CHECK(nowhere.code == 6);
  CHECK(Json::parse(nowhere.out)["errors"][0]["code"] == "io");
  const Outcome wrong = run({"hash", path, "--set", "reach", "--json"});
  CHECK(wrong.code == 2);
  CHECK(wrong.out.empty());
  CHECK(has(wrong.err, "[usage]"));
}

TEST_CASE("With --json problems have file, line, column and a pointer into that file") {
  const Folder folder;
  folder.write("a.json", too_small);
  const std::string path = (folder.path() / "a.json").string();
  for (const std::string command : {"validate", "eval"}) {
    const Outcome outcome = run({command, path, "--json"});
    CHECK(outcome.code == 3);
    CHECK(outcome.err.empty());
    const Json error = Json::parse(outcome.out)["errors"][0];
    CHECK(error["file"] == path);
    CHECK(error["line"] == 3);
    CHECK(error["column"] == 59);
    CHECK(Json::parse(too_small).at(Json::json_pointer(error["pointer"].get<std::string>())) == -8);
    CHECK(error["code"] == "out-of-range");
  }
  const Json option = Json::parse(run({"eval", path, "--json", "--set", "reach=1"}).out)["errors"][0];
  CHECK_FALSE(option.contains("file"));
}

TEST_CASE("Colors come when they are asked for, and never into a file otherwise") {
  const std::string escape = "\x1b[";
  CHECK_FALSE(has(run({"eval", "-"}, too_small).err, escape));
  CHECK_FALSE(has(run({"eval", "-", "--color", "never"}, too_small).err, escape));
  const std::string colored = run({"eval", "-", "--color", "always"}, too_small).err;
  CHECK(has(colored, "\x1b[1;31merror\x1b[0m: ball.segments"));
  const Variable unwanted("NO_COLOR", "1");
  CHECK_FALSE(has(run({"eval", "-", "--color", "auto"}, too_small).err, escape));
  CHECK(run({"eval", "-", "--color", "blue"}, too_small).code == 2);
}

TEST_CASE("Quiet tells errors only, verbose the times of the nodes") {
  const std::string path = example("fig11_patch").string();
  const Outcome quiet = run({"eval", path, "--quiet"});
  CHECK(quiet.code == 0);
  CHECK(quiet.out.empty());
  CHECK(quiet.err.empty());
  CHECK(has(run({"eval", "-", "--quiet"}, too_small).err, "error: ball.segments"));
  const Outcome verbose = run({"eval", path, "-v"});
  CHECK(has(verbose.out, "out: "));
  CHECK(has(verbose.err, " ms  patch (patch)\n"));
  CHECK(run({"eval", path, "-v", "--quiet"}).code == 2);
}

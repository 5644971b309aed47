// Every option of every command that the documentation names, with what it does and on a wrong call.

#include <map>
#include <regex>
#include <sstream>

#include "tests/cli/graph_folder.h"
#include "tests/cli/real_program.h"
#include "tests/support/documents.h"

using namespace dini;
using namespace dini::support;

namespace {

struct Option {
  std::string name;
  bool takes_value = false;
};

/// The options of each command, as docs/cli.md lists them.
std::map<std::string, std::vector<Option>> documented_options() {
  std::istringstream page(contents(std::filesystem::path(DINI_SOURCE_DIR) / "docs/cli.md"));
  static const std::regex heading("## dini ([a-z ]+)"), row(R"(\| `(?:-[a-z], )?(--[a-z-]+)( [A-Z]+)?`.*)");
  std::map<std::string, std::vector<Option>> commands;
  std::string line, command;
  for (std::smatch match; std::getline(page, line);) {
    if (std::regex_match(line, match, heading)) {
      command = match[1];
      commands[command];
    } else if (std::regex_match(line, match, row)) {
      commands.at(command).push_back({match[1], match[2].matched});
    }
  }
  return commands;
}

std::vector<std::string> words_of(const std::string& command) {
  std::istringstream text(command);
  return {std::istream_iterator<std::string>(text), {}};
}

/// A ball whose radius is a parameter, and whose mesh may come from a file.
Json adjustable_ball() {
  Json graph = document({{"ball", make("sphere_mesh", {{"radius", {{"parameter", "radius"}}}, {"segments", 64}})},
                         {"out", make("export", {{"model", from("ball")}})}});
  graph["parameters"] = {{"radius", {{"type", "number"}, {"default", 1}, {"min", 0.1}, {"max", 9}}}};
  return graph;
}

/// A graph of a mesh file called "mesh", which can be swept too.
Json scaled_import() {
  Json graph = document({{"mesh", make("import", {{"asset", "mesh"}, {"scale", {{"parameter", "size"}}}})},
                         {"out", make("export", {{"model", from("mesh")}})}});
  graph["parameters"] = {{"size", {{"type", "number"}, {"default", 1}}}};
  return graph;
}

/// Work of some seconds.
Json slow() {
  Json graph = document({{"grid", make("grid", {{"count_u", 1500}, {"count_v", 1500}})},
                         {"pair", make("point_pair", {{"position", {0, 0, 1}}})},
                         {"bent", make("warp", {{"shape", from("grid")},
                                                {"generators", Json::array({from("pair"), from("pair")})},
                                                {"power", 1.5},
                                                {"softening", {{"parameter", "soft"}}}})},
                         {"skin", make("surface", {{"shape", from("bent")}})},
                         {"out", make("export", {{"model", from("skin")}})}});
  graph["parameters"] = {{"soft", {{"type", "number"}, {"default", 1}}}};
  return graph;
}

}  // namespace

TEST_CASE("Every command refuses an option that it does not have, and one that is given without its value") {
  const auto commands = documented_options();
  REQUIRE(commands.size() > 15);
  for (const auto& [command, options] : commands) {
    std::vector<std::string> unknown = words_of(command);
    unknown.emplace_back("--no-such-option");
    const Outcome outcome = run(unknown);
    CAPTURE(command, outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(has(outcome.err, "[usage]"));
    std::vector<std::string> help = words_of(command);
    help.emplace_back("--help");
    const Outcome helped = run(help);
    CHECK(helped.code == 0);
    for (const Option& option : options) {
      CAPTURE(option.name);
      CHECK(has(helped.out, option.name));
      if (!option.takes_value) continue;
      std::vector<std::string> words = words_of(command);
      words.push_back(option.name);
      const Outcome incomplete = run(words);
      CHECK(incomplete.code == 2);
      CHECK(has(incomplete.err, option.name));
      CHECK(has(incomplete.err, "--help [usage]"));
    }
  }
}

TEST_CASE("Colors are a choice of every command that tells problems") {
  const GraphFolder files;
  const std::string broken = files.graph("broken.json", "no graph");
  for (const auto& [command, options] : documented_options()) {
    const bool has_color = std::ranges::find(options, "--color", &Option::name) != options.end();
    if (!has_color) continue;
    std::vector<std::string> words = words_of(command);
    const std::size_t documents = command == "merge" ? 3 : command == "diff" ? 2 : 1;
    words.insert(words.end(), documents, broken);
    if (command == "inspect") words.emplace_back("ball");
    if (command == "fit") words.insert(words.end(), {"--vary", "x=0:1", "--minimize", "mass.volume"});
    if (command == "sweep") words.insert(words.end(), {"--list", "x=1"});
    for (const auto& [color, colored] : std::map<std::string, bool>{{"always", true}, {"never", false}}) {
      std::vector<std::string> all = words;
      all.insert(all.end(), {"--color", color});
      const Outcome outcome = run(all);
      CAPTURE(all, outcome.err);
      CHECK(outcome.code == 3);
      CHECK(has(outcome.err, "\x1b[1;31merror\x1b[0m: ") == colored);
    }
    words.insert(words.end(), {"--color", "blue"});
    CHECK(run(words).code == 2);
  }
}

TEST_CASE("Threads and instructions change nothing of the answer of any command, and wrong ones are refused") {
  const GraphFolder files;
  const std::string graph = files.graph("ball.json", adjustable_ball());
  const auto answer = [&](const std::string& command, const std::vector<std::string>& more) {
    std::vector<std::string> words = {command, graph};
    if (command == "inspect") words.insert(words.end(), {"ball", "--full"});
    if (command == "eval") words.insert(words.end(), {"-o", "-"});
    if (command == "test") words.insert(words.end(), {"--quiet"});
    if (command == "sweep") words.insert(words.end(), {"--list", "radius=1,2", "--csv", "-"});
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  };
  for (const std::string command : {"eval", "inspect", "sweep", "test"}) {
    CAPTURE(command);
    const Outcome usual = answer(command, {});
    REQUIRE(usual.code == 0);
    const Outcome wrong = answer(command, {"--instruction-set", "abacus"});
    CHECK(wrong.code == 2);
    REQUIRE(has(wrong.err, "'abacus' is not available; there are "));
    const std::string list = wrong.err.substr(wrong.err.find("there are ") + 10);
    const std::string first = list.substr(0, list.find(' '));
    CHECK(answer(command, {"--instruction-set", first}).out == usual.out);
    CHECK(answer(command, {"--threads", "1"}).out == usual.out);
    CHECK(answer(command, {"--threads", "0"}).code == 2);
    CHECK(answer(command, {"--threads", "many"}).code == 2);
  }
}

TEST_CASE("A model that is not done in time ends eval, test and sweep with 5, and none is left behind") {
  const GraphFolder files;
  const std::string graph = files.graph("slow.json", slow());
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"eval", graph, "-o", files.at("m.glb")},
                                             {"test", graph},
                                             {"sweep", graph, "--list", "soft=1,2", "-o", files.at("m{soft}.glb")}}) {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"--deadline-ms", "1"});
    const Outcome outcome = run(all);
    CAPTURE(words, outcome.err);
    CHECK(outcome.code == 5);
    CHECK(has(outcome.err, "[deadline]"));
    all.back() = "0";
    CHECK(run(all).code == 2);
  }
  CHECK_FALSE(std::filesystem::exists(files.at("m.glb")));
  CHECK_FALSE(std::filesystem::exists(files.at("m1.glb")));
}

TEST_CASE("Eval, test and sweep take a mesh file, and say that they lack it") {
  const GraphFolder files;
  files.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string graph = files.graph("import.json", scaled_import());
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"eval", graph}, {"test", graph}, {"sweep", graph, "--list", "size=1,2"}}) {
    const Outcome lacking = run(words);
    CAPTURE(words, lacking.err);
    CHECK(lacking.code == 3);
    CHECK(has(lacking.err, "[unknown-asset]"));
    std::vector<std::string> all = words;
    all.insert(all.end(), {"--asset", "mesh=" + files.at("mesh.obj")});
    CHECK(run(all).code == 0);
    all.back() = "mesh";
    CHECK(run(all).code == 2);
    all.back() = "mesh=" + files.at("nowhere.obj");
    CHECK(run(all).code == 6);
  }
}

TEST_CASE("The inputs that name files are called so that the program knows when those of the examples are needed") {
  const Json nodes = Json::parse(run({"nodes", "--json"}).out)["nodes"];
  std::size_t found = 0;
  for (const Json& node : nodes) {
    for (const Json& input : node["inputs"]) {
      if (!input.value("names_file", false)) continue;
      ++found;
      CHECK(input["name"] == "asset");
    }
  }
  CHECK(found > 0);
  CHECK(run({"eval", example("fig12_imported_mesh").string()}).code == 0);
}

TEST_CASE("A sweep takes format and quality, is quiet, and goes on unless it is told not to") {
  const GraphFolder files;
  const std::string graph = files.graph("ball.json", adjustable_ball());
  const auto sweep = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"sweep", graph, "--list", "radius=1,99,2", "--jobs", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  };
  const Outcome quiet = sweep({"-o", files.at("{index}"), "--format", "obj", "--keep-going", "--quiet"});
  CHECK(quiet.code == 3);
  CHECK(quiet.out.empty());
  CHECK(has(quiet.err, "variant 1 (radius=99)"));
  CHECK(has(contents(files.at("0")), "\nv "));
  CHECK(std::filesystem::exists(files.at("2")));
  CHECK_FALSE(std::filesystem::exists(files.at("1")));
  CHECK(sweep({"--out", files.at("draft{index}.glb"), "--quality", "draft", "--fail-fast"}).code == 3);
  CHECK_FALSE(std::filesystem::exists(files.at("draft2.glb")));
  REQUIRE(run({"eval", graph, "--quality", "draft", "-o", files.at("draft.glb")}).code == 0);
  CHECK(contents(files.at("draft0.glb")) == contents(files.at("draft.glb")));
  CHECK(sweep({"--keep-going", "--fail-fast"}).code == 2);
  CHECK(sweep({"--quality", "best"}).code == 2);
  CHECK(has(sweep({"--format", "dwg"}).err, "dwg"));
  CHECK(sweep({"--format", "dwg"}).code != 0);
}

TEST_CASE("The long names of options do what the short ones do") {
  const GraphFolder files;
  const std::string graph = files.graph("ball.json", adjustable_ball());
  REQUIRE(run({"eval", graph, "--out", files.at("a.glb"), "--verbose"}).code == 0);
  REQUIRE(run({"eval", graph, "-o", files.at("b.glb")}).code == 0);
  CHECK(contents(files.at("a.glb")) == contents(files.at("b.glb")));
  CHECK(has(run({"test", graph, "--verbose"}).err, " ms  ball (sphere_mesh)\n"));
  CHECK(run({"merge", graph, graph, graph, "--out", files.at("merged.json")}).code == 0);
  CHECK(Json::parse(files.read("merged.json")) == adjustable_ball());
}

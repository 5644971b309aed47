// `dini test`: cases, golden results, exit codes, and what is written.

#include <regex>

#include "tests/cli/real_program.h"
#include "tests/support/documents.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A ball whose radius is a parameter and must be at most 3, in the layout of people.
Json checked_ball() {
  Json graph = document({{"size", make("check", {{"value", {{"parameter", "radius"}}}, {"maximum", 3}})},
                         {"ball", make("sphere_mesh", {{"segments", 16}, {"rings", 8}, {"radius", from("size")}})},
                         {"out", make("export", {{"model", from("ball")}})}});
  graph["parameters"] = {{"radius", {{"type", "number"}, {"default", 1}}}};
  return graph;
}

Json cases(const Json& listed) { return {{"cases", listed}}; }

/// A folder with one graph and an approved result.
struct Project : Folder {
  Project() {
    write_json("ball.json", checked_ball());
    REQUIRE(test({"--update-golden", "--golden", at("golden")}).code == 0);
  }
  void write_json(const std::string& name, const Json& json) const { write(name, json.dump(1)); }
  std::string at(const std::string& name) const { return (path() / name).string(); }
  Outcome test(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"test", path().string()};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  /// The golden result with every place of a pattern replaced.
  void damage(const std::string& pattern, const std::string& by) const {
    write("golden/ball.golden.json", std::regex_replace(read("golden/ball.golden.json"), std::regex(pattern), by));
  }
};

/// A node of the document under another name.
Json renamed(const Json& graph, const std::string& from_id, const std::string& to_id) {
  const std::string text = std::regex_replace(graph.dump(), std::regex("\"" + from_id + "\""), "\"" + to_id + "\"");
  return Json::parse(text);
}

}  // namespace

TEST_CASE("A parameter that shapes the model changes it, and a moved node, a renamed one and another engine do not") {
  const Project project;
  const Outcome good = project.test();
  CHECK(good.code == 0);
  CHECK(has(good.out, "  same\n1 passed\n"));

  SECTION("a parameter") {
    Json graph = checked_ball();
    graph["parameters"]["radius"]["default"] = 1.01;
    project.write_json("ball.json", graph);
    const Outcome changed = project.test();
    CHECK(changed.code == 1);
    CHECK(has(changed.out, "  changed\n0 passed, 1 failed"));
    CHECK(has(changed.err, "ball.json:"));
    CHECK(has(changed.err, ": error: out: the model is not that of the golden result, which was of another graph; "));
    CHECK(has(changed.err, "largest x: 1.0"));
    CHECK(has(changed.err, "[golden-changed]"));
    CHECK(project.test({"--tolerance", "0.02"}).code == 0);
    CHECK(project.test({"--update-golden"}).code == 0);
    CHECK(project.test().code == 0);
  }
  SECTION("a moved node") {
    Json graph = checked_ball();
    graph["ui"] = {{"nodes", {{"ball", {{"x", 100}, {"y", 20}}}}}};
    project.write_json("ball.json", graph);
    CHECK(has(project.test().out, "  same\n"));
  }
  SECTION("a renamed node") {
    project.write_json("ball.json", renamed(renamed(checked_ball(), "ball", "sphere"), "size", "limit"));
    const Outcome outcome = project.test();
    CAPTURE(outcome.err);
    CHECK(outcome.code == 0);
    CHECK(has(outcome.out, "  same"));
  }
  SECTION("another engine that rounds otherwise") {
    project.damage("\"engine\": \"[^\"]*\"", "\"engine\": \"0.0.1\"");
    project.damage("\"sha256\": \"[0-9a-f]{4}", "\"sha256\": \"0000");
    const Outcome outcome = project.test();
    CHECK(outcome.code == 0);
    CHECK(has(outcome.out, "same within tolerance ("));
  }
}

TEST_CASE("A golden result that is gone, damaged or of another output fails the case") {
  const Project project;
  project.damage("\"out\": \\{", "\"other\": {");
  const Outcome other = project.test();
  CHECK(other.code == 1);
  CHECK(has(other.err, "the golden result has no output out [golden-missing]"));
  CHECK(has(other.err, "the output other is gone [golden-changed]"));
  project.write("golden/ball.golden.json", "{}");
  CHECK(project.test().code == 1);
  CHECK(has(project.test().err, "this is no golden result [bad-golden]"));
  std::filesystem::remove(project.at("golden/ball.golden.json"));
  const Outcome gone = project.test();
  CHECK(gone.code == 1);
  CHECK(has(gone.out, "no golden result\n"));
  CHECK(has(gone.err, "--update-golden writes it [golden-missing]"));
  std::filesystem::remove(project.at("golden"));
  CHECK(project.test().code == 0);
  CHECK(has(project.test().out, "not compared\n"));
  CHECK(project.test({"--golden", project.at("nowhere")}).code == 1);
}

TEST_CASE("A golden result that no case has any more fails, and --update-golden takes it away") {
  const Project project;
  const Json small = {{"parameters", {{"radius", 0.5}}}}, wide = {{"parameters", {{"radius", 2}}}};
  project.write_json("ball.cases.json", cases({{"small", small}, {"wide", wide}}));
  // The result of the graph without cases is left over now.
  const Outcome first = project.test({"--update-golden"});
  CHECK(first.code == 0);
  CHECK(has(first.out, "removed  " + project.at("golden/ball.golden.json")));
  CHECK_FALSE(std::filesystem::exists(project.at("golden/ball.golden.json")));
  CHECK(project.test().code == 0);

  project.write_json("ball.cases.json", cases({{"small", small}}));
  const std::string left = project.at("golden/ball.wide.golden.json");
  const Outcome stale = project.test({"--junit", project.at("j.xml"), "--report", project.at("r.json")});
  CHECK(stale.code == 1);
  CHECK(has(stale.out, "1 passed, 1 failed\n"));
  CHECK(has(stale.err, "the golden result " + left + " is of the case wide, which is no more"));
  CHECK(has(stale.err, "[golden-stale]"));
  CHECK(has(contents(project.at("j.xml")), "<failure type=\"golden-stale\""));
  CHECK(json_in(project.at("r.json"))["succeeded"] == false);
  Json failing = wide;
  failing["fails"] = "check-failed";
  project.write_json("ball.cases.json", cases({{"small", small}, {"wide", failing}}));
  CHECK(has(project.test().err, "of the case wide, which has to fail"));
  // With the golden folder named, what is of a graph that was tested is told just so.
  CHECK(has(project.test({"--golden", project.at("golden")}).err, "[golden-stale]"));
  project.write_json("ball.cases.json", cases({{"small", small}}));
  CHECK(project.test({"--update-golden"}).code == 0);
  CHECK_FALSE(std::filesystem::exists(left));
  CHECK(project.test().code == 0);
}

TEST_CASE("Golden results of graphs that were not tested, cannot be read or are of others are left alone") {
  const Project project;
  project.write_json("other.json", checked_ball());
  project.write_json("ball.big.json", checked_ball());
  REQUIRE(project.test({"--update-golden"}).code == 0);
  project.write("golden/notes.txt", "by hand");
  const auto test = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all = {"test"};
    all.insert(all.end(), words.begin(), words.end());
    return run(all);
  };
  CHECK(project.test().code == 0);
  CHECK(test({project.at("ball.json")}).code == 0);
  CHECK(test({project.at("ball.json"), "--update-golden"}).code == 0);
  CHECK(std::filesystem::exists(project.at("golden/other.golden.json")));
  CHECK(std::filesystem::exists(project.at("golden/ball.big.golden.json")));
  project.write("other.cases.json", "{");
  CHECK(project.test({"--update-golden"}).code == 3);
  CHECK(std::filesystem::exists(project.at("golden/other.golden.json")));
  // A graph that is gone is told of where the folder was tested, and not where others were tested by their names.
  std::filesystem::remove(project.at("other.cases.json"));
  std::filesystem::remove(project.at("other.json"));
  CHECK(test({project.at("ball.json")}).code == 0);
  const Outcome gone = project.test();
  CHECK(gone.code == 1);
  CHECK(has(gone.err, "is of no graph that is here"));
  CHECK(project.test({"--update-golden"}).code == 0);
  CHECK_FALSE(std::filesystem::exists(project.at("golden/other.golden.json")));
  CHECK(project.read("golden/notes.txt") == "by hand");
}

TEST_CASE("In a folder of all golden results those of graphs that are gone are told of") {
  const Project project;
  std::filesystem::create_directories(project.at("more/deep"));
  project.write_json("more/deep/ball.json", checked_ball());
  project.write_json("more/deep/other.json", checked_ball());
  const Folder kept("kept");
  const std::string golden = kept.path().string(), left = golden + "/more/deep/other.golden.json";
  const auto test = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "test");
    words.insert(words.end(), {"--golden", golden});
    return run(words);
  };
  REQUIRE(test({project.at(""), "--update-golden"}).code == 0);
  REQUIRE(std::filesystem::exists(left));
  std::filesystem::remove(project.at("more/deep/other.json"));
  const Outcome gone = test({project.at("")});
  CHECK(gone.code == 1);
  CHECK(has(gone.err, "the golden result " + left + " is of no graph in the folders that were tested"));
  CHECK(has(gone.err, "[golden-stale]"));
  // Who tests one graph says nothing of the others.
  CHECK(test({project.at("ball.json")}).code == 0);
  CHECK(test({project.at("ball.json"), "--update-golden"}).code == 0);
  CHECK(std::filesystem::exists(left));
  const Outcome updated = test({project.at(""), "--update-golden"});
  CHECK(updated.code == 0);
  CHECK(has(updated.out, "removed  " + left));
  CHECK_FALSE(std::filesystem::exists(left));
  CHECK(std::filesystem::exists(golden + "/more/deep/ball.golden.json"));
  CHECK(test({project.at("")}).code == 0);
}

TEST_CASE("Each case of a graph is evaluated, and may have to fail") {
  const Folder folder;
  folder.write("ball.json", checked_ball().dump());
  const auto with = [&](const Json& listed) {
    folder.write("ball.cases.json", cases(listed).dump(1));
    return run({"test", (folder.path() / "ball.json").string()});
  };
  const Json small = {{"parameters", {{"radius", 0.5}}}}, large = {{"parameters", {{"radius", 4}}}};
  Json refused = large;
  refused["fails"] = "check-failed";
  const Outcome good = with({{"small", small}, {"too large", refused}, {"usual", Json::object()}});
  CHECK(good.code == 0);
  CHECK(has(good.out, "ball.json: too large"));
  CHECK(has(good.out, "3 passed\n"));
  const Outcome check = with({{"large", large}});
  CHECK(check.code == 1);
  CHECK(has(check.err, "case large: "));
  CHECK(has(check.err, "[check-failed]"));
  Json succeeds = small;
  succeeds["fails"] = "check-failed";
  CHECK(has(with({{"small", succeeds}}).err,
            "it was expected to fail with check-failed, and did not [unexpected-success]"));
  CHECK(with({{"small", succeeds}}).code == 1);
  CHECK(with({{"wrong", {{"parameters", {{"radiux", 1}}}}}}).code == 3);
}

TEST_CASE("A file of cases that is wrong is told with its place, and fails") {
  const Folder folder;
  folder.write("ball.json", checked_ball().dump());
  for (const auto& [text, said] : std::vector<std::pair<std::string, std::string>>{
           {"{", "ball.cases.json:1:2: error: the text is not JSON"},
           {"{}", "ball.cases.json: error: a file of cases is an object with the member cases"},
           {R"({"cases": {}})", "there is no case"},
           {R"({"cases": {"a/b": {}}})", "names of cases are"},
           {R"({"cases": {"a": 1}})", "ball.cases.json:1:12: error: /cases/a: a case is an object"},
           {R"({"cases": {"a": {"params": {}}}})", "there is parameters, fails, description"},
           {R"({"cases": {"a": {"parameters": 1}}})", "parameters are an object"},
           {R"({"cases": {"a": {"fails": 1}}})", "fails is a text"},
           {R"({"cases": {"a": {"fails": "check-fails"}}})", "did you mean \"check-failed\"?"}}) {
    folder.write("ball.cases.json", text);
    const Outcome outcome = run({"test", folder.path().string()});
    CAPTURE(outcome.err);
    CHECK(outcome.code == 3);
    CHECK(has(outcome.err, said));
  }
}

TEST_CASE("Graphs are found in folders, broken ones too, and other files are left alone") {
  const Folder folder;
  folder.write("a/ball.json", checked_ball().dump());
  folder.write("a/golden/ball.json", checked_ball().dump());
  folder.write(".hidden/ball.json", checked_ball().dump());
  folder.write("node_modules/ball.json", checked_ball().dump());
  folder.write("package.json", R"({"name": "other"})");
  folder.write("b c/ball.json", checked_ball().dump());
  const auto test = [&](const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"test", folder.path().string()};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  };
  std::filesystem::remove_all(folder.path() / "a/golden");
  CHECK(has(test().out, "2 passed\n"));
  // One folder for all golden results, which lie in it as the graphs do.
  const std::string golden = (folder.path() / "all").string();
  CHECK(test({"--golden", golden, "--update-golden"}).code == 0);
  CHECK(std::filesystem::exists(folder.path() / "all/b c/ball.golden.json"));
  CHECK(test({"--golden", golden}).code == 0);
  folder.write("broken.json", "{\"format\": 1, \"nodes\": {");
  const Outcome broken = test();
  CHECK(broken.code == 3);
  CHECK(has(broken.out, "2 passed, 1 failed\n"));
  CHECK(run({"test", folder.path().string(), (folder.path() / "none.json").string()}).code == 6);
}

TEST_CASE("All reports are written however a test ends, and none of before survives") {
  const Project project;
  const std::vector<std::string> words = {"--report", project.at("r.json"), "--junit",    project.at("j.xml"),
                                          "--sarif",  project.at("s.json"), "--markdown", project.at("m.md")};
  const auto reports = [&](int code) {
    const Outcome outcome = project.test(words);
    CAPTURE(outcome.err);
    CHECK(outcome.code == code);
    const Json report = json_in(project.at("r.json"));
    CHECK(report["succeeded"] == (code == 0));
    CHECK(json_in(project.at("s.json"))["version"] == "2.1.0");
    CHECK(contents(project.at("j.xml")).starts_with("<?xml"));
    return report;
  };
  CHECK(reports(0)["cases"][0]["outputs"]["out"]["golden"] == "same");
  CHECK(contents(project.at("m.md")).starts_with("## dini test: 1 passed\n"));
  Json graph = checked_ball();
  graph["parameters"]["radius"]["default"] = 2;
  project.write_json("ball.json", graph);
  const Json changed = reports(1);
  CHECK(changed["cases"][0]["outputs"]["out"]["differences"].size() > 2);
  CHECK(has(contents(project.at("m.md")), "### What is wrong"));
  graph["nodes"]["ball"]["inputs"]["segments"] = -1;
  project.write_json("ball.json", graph);
  CHECK(reports(3)["cases"][0]["errors"][0]["file"] == project.at("ball.json"));
  graph = checked_ball();
  graph["nodes"]["n"] = make("expression", {{"formula", "1 / x"}, {"x", 0}});
  graph["nodes"]["ball"]["inputs"]["radius"] = from("n");
  project.write_json("ball.json", graph);
  reports(4);
  graph["nodes"]["n"] = make("range", {{"count", 10'000'000}});
  project.write_json("ball.json", graph);
  reports(5);
  std::filesystem::remove(project.at("ball.json"));
  CHECK(project.test(words).code == 2);
  CHECK(json_in(project.at("r.json"))["succeeded"] == false);
}

TEST_CASE("Wrong calls of test are refused, and nothing is replaced that is not its own") {
  const Project project;
  project.write("notes.txt", "remember the milk");
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"--junit", project.at("notes.txt")},
                                             {"--sarif", project.at("ball.json")},
                                             {"--markdown", project.at("notes.txt")},
                                             {"--report", project.at("golden/ball.golden.json")},
                                             {"--report", project.at("x"), "--junit", project.at("x")},
                                             {"--report", "-", "--json"},
                                             {"--tolerance", "2"},
                                             {"--jobs", "0"},
                                             {"--fail-fast", "--keep-going"},
                                             {"--quiet", "-v"},
                                             {"--unknown"}}) {
    const Outcome outcome = project.test(more);
    CAPTURE(more, outcome.err);
    CHECK(outcome.code == 2);
    CHECK(has(outcome.err, "[usage]"));
  }
  CHECK(project.read("notes.txt") == "remember the milk");
  CHECK(project.test({"--junit", project.at("none/j.xml")}).code == 6);
  CHECK(project.test({"--junit", project.at("none/j.xml"), "--mkdir"}).code == 0);
}

TEST_CASE("Quiet tells what failed only, verbose the nodes, and JSON is all there is with --json") {
  const Project project;
  const Outcome quiet = project.test({"--quiet"});
  CHECK(quiet.out.empty());
  CHECK(quiet.err.empty());
  CHECK(has(project.test({"-v"}).err, " ms  ball (sphere_mesh)\n"));
  CHECK(Json::parse(project.test({"--json"}).out)["passed"] == 1);
  CHECK(Json::parse(project.test({"--report", "-"}).out)["passed"] == 1);
  CHECK(project.test({"--junit", "-"}).out.starts_with("<?xml"));
  CHECK(has(project.test({"--color", "always"}).out, "\x1b[32mpassed\x1b[0m"));
  project.write_json("a bad.json", Json{{"format", 1}, {"nodes", Json::object()}});
  const Outcome fast = project.test({"--fail-fast", "--jobs", "1"});
  CHECK(fast.code == 3);
  CHECK(has(fast.err, "there is nothing to test: no export node and no check"));
  CHECK(has(fast.out, "0 passed, 1 failed, 1 skipped\n"));
}

TEST_CASE("A graph without outputs is tested by its checks alone") {
  const Folder folder;
  folder.write("check.json", document({{"check", make("check", {{"value", 2}, {"maximum", 1}})}}).dump());
  const Outcome outcome = run({"test", folder.path().string()});
  CHECK(outcome.code == 1);
  CHECK(has(outcome.err, "[check-failed]"));
  folder.write("check.json", document({{"check", make("check", {{"value", 1}, {"maximum", 1}})}}).dump());
  CHECK(run({"test", folder.path().string()}).code == 0);
}

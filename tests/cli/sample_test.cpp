// The sample repository examples/ci, run as a pipeline runs it: when it is well, and with each thing that goes wrong.

#include <regex>

#include "tests/cli/real_program.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A copy of the sample.
struct Sample : Folder {
  Sample() {
    std::filesystem::copy(std::filesystem::path(DINI_EXAMPLES) / "ci", path(),
                          std::filesystem::copy_options::recursive);
  }
  Outcome make(const std::string& target) const {
    return Program({"/usr/bin/env", "make", "-s", "-C", path().string(), target, std::string("DINI=") + DINI_PROGRAM})
        .wait();
  }
  Outcome test() const { return run({"test", (path() / "parts").string(), "--report", (path() / "r.json").string()}); }
  void change(const std::string& name, const std::string& pattern, const std::string& by) const {
    const std::string before = read(name);
    const std::string after = std::regex_replace(before, std::regex(pattern), by);
    REQUIRE(before != after);
    write(name, after);
  }
};

}  // namespace

TEST_CASE("The sample is well, and its pipeline writes models and reports") {
  const Sample sample;
  const Outcome check = sample.make("check");
  CAPTURE(check.out, check.err);
  CHECK(check.code == 0);
  CHECK(has(check.out, "10 passed\n"));
  CHECK_FALSE(has(check.out, "within tolerance"));
  for (const char* report : {"junit.xml", "dini.sarif", "summary.md", "report.json"}) {
    CHECK_FALSE(sample.read(std::string("build/") + report).empty());
  }
  CHECK(sample.make("models").code == 0);
  CHECK(std::filesystem::exists(sample.path() / "build/models/wheel.rim_only.glb"));
  CHECK(std::filesystem::exists(sample.path() / "build/models/knot.out.glb"));
}

TEST_CASE("What goes wrong in the sample ends with its exit code and a report that says so") {
  const Sample sample;
  int code = 1;
  std::string problem = "golden-changed";
  SECTION("another value") { sample.change("parts/knot.json", "\"radius\": 0.14", "\"radius\": 0.15"); }
  SECTION("a case with another value") { sample.change("parts/ring.cases.json", "0\\.2", "0.25"); }
  SECTION("a golden result that is gone") {
    std::filesystem::remove(sample.path() / "parts/golden/knot.golden.json");
    problem = "golden-missing";
  }
  SECTION("a golden result of something else") {
    sample.change("parts/golden/knot.golden.json", "\"sha256\": \"[0-9a-f]{4}", "\"sha256\": \"0000");
    sample.change("parts/golden/knot.golden.json", "\"triangles\": 1", "\"triangles\": 2");
  }
  SECTION("a check that fails") {
    sample.change("parts/ring.cases.json", "0\\.2", "0.5");
    problem = "check-failed";
  }
  SECTION("a graph that is wrong") {
    sample.change("parts/knot.json", "\"tube\"", "\"tubes\"");
    code = 3;
    problem = "unknown-node-type";
  }
  SECTION("a parameter that is not there") {
    sample.change("parts/ring.cases.json", "\"thickness\": 0.2", "\"thickens\": 0.2");
    code = 3;
    problem = "unknown-parameter";
  }
  SECTION("a mesh file that is not there") {
    sample.change("parts/ball.json", "\\{\"type\": \"sphere_mesh\".*\\}\\}",
                  "{\"type\": \"import\", \"inputs\": {\"asset\": \"nowhere\"}}");
    code = 3;
    problem = "unknown-asset";
  }
  const Outcome outcome = sample.test();
  CAPTURE(outcome.out, outcome.err);
  CHECK(outcome.code == code);
  CHECK(has(outcome.err, "[" + problem + "]"));
  CHECK(json_in(sample.path() / "r.json")["succeeded"] == false);
}

// `dini sweep`: what is combined, written, split, and not made twice.

#include <algorithm>
#include <memory>
#include <set>
#include <signal.h>

#include "tests/cli/real_program.h"
#include "tests/support/documents.h"
#include "tests/support/eventually.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

Json segmented_ball(std::size_t segments) {
  Json graph = document({{"ball", make("sphere_mesh", {{"radius", {{"parameter", "radius"}}}, {"segments", segments}})},
                         {"painted", make("color", {{"shape", from("ball")}, {"color", {{"parameter", "paint"}}}})},
                         {"twice", make("expression", {{"formula", "2 * x"}, {"x", {{"parameter", "radius"}}}})},
                         {"out", make("export", {{"model", from("painted")}})}});
  graph["parameters"] = {{"radius", {{"type", "number"}, {"default", 1}, {"min", 0.1}, {"max", 9}}},
                         {"paint", {{"type", "color"}, {"default", {1, 0, 0}}}}};
  return graph;
}

struct Sweeps : Folder {
  explicit Sweeps(std::size_t segments = 16) { write("ball.json", segmented_ball(segments).dump()); }
  std::string at(const std::string& name) const { return (path() / name).string(); }
  std::vector<std::string> words(const std::vector<std::string>& more) const {
    std::vector<std::string> all = {DINI_PROGRAM, "sweep", at("ball.json")};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Outcome sweep(const std::vector<std::string>& more) const { return Program(words(more)).wait(); }
  /// Names of all models in a folder.
  std::set<std::string> names(const std::string& folder) const {
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(path() / folder)) {
      if (entry.path().extension() == ".glb") found.insert(entry.path().filename().string());
    }
    return found;
  }
  /// Names and bytes of all models in a folder.
  std::map<std::string, std::string> models(const std::string& folder) const {
    std::map<std::string, std::string> found;
    for (const std::string& name : names(folder)) found[name] = contents(path() / folder / name);
    return found;
  }
};

}  // namespace

TEST_CASE("All values of all parameters are combined, and told in a table") {
  const Sweeps sweeps;
  const Outcome outcome = sweeps.sweep({"--grid", "radius=1:2:3", "--list", "paint=[1,0,0],[0,0,1]", "-o",
                                        sweeps.at("out/{index} {radius}.glb"), "--mkdir", "--csv", sweeps.at("m.csv"),
                                        "--measure", "twice", "--report", sweeps.at("r.json")});
  CAPTURE(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(outcome.out == "6 of 6 variants are done\n");
  CHECK(outcome.err.empty());
  const auto models = sweeps.models("out");
  CHECK(models.size() == 6);
  REQUIRE(models.contains("1 1.5.glb"));
  const std::string table = contents(sweeps.at("m.csv"));
  CHECK(table.starts_with("index,paint,radius,file,result,bytes,vertices,triangles,sha256,twice\r\n0,\"[1,0,0]\",1,"));
  CHECK(has(table, "\r\n5,\"[0,0,1]\",2," + sweeps.at("out/5 2.glb") + ",ok,"));
  CHECK(has(table, ",4.0\r\n"));
  const Json variants = json_in(sweeps.at("r.json"))["variants"];
  CHECK(variants[1]["setting"] == Json{{"paint", {1, 0, 0}}, {"radius", 1.5}});
  CHECK(variants[1]["measures"]["twice"] == 3);
  REQUIRE(run({"eval", sweeps.at("ball.json"), "--set", "radius=1.5", "-o", sweeps.at("alone.glb")}).code == 0);
  CHECK(models.at("1 1.5.glb") == contents(sweeps.at("alone.glb")));
}

TEST_CASE("Several outputs of each variant have a file and a row each, and one that fails stops no other") {
  const Sweeps sweeps;
  Json graph = segmented_ball(16);
  graph["nodes"]["left"] = make("expression", {{"formula", "2 - x"}, {"x", {{"parameter", "radius"}}}});
  graph["nodes"]["inner"] = make("sphere_mesh", {{"radius", from("left")}, {"segments", 8}});
  graph["nodes"]["core"] = make("export", {{"model", from("inner")}});
  sweeps.write("ball.json", graph.dump());
  const std::vector<std::string> words = {"--grid",   "radius=1:3:2",
                                          "--output", "out",
                                          "--output", "core",
                                          "-o",       sweeps.at("{output}-{radius}.glb"),
                                          "--csv",    "-",
                                          "--report", sweeps.at("r.json")};
  const Outcome outcome = sweeps.sweep(words);
  CAPTURE(outcome.out, outcome.err);
  CHECK(outcome.code == 4);
  CHECK(outcome.out.starts_with("index,radius,output,file,result,bytes,vertices,triangles,sha256\r\n0,1,out,"));
  CHECK(has(outcome.out, "\r\n1,3,out," + sweeps.at("out-3.glb") + ",ok,"));
  CHECK(has(outcome.out, "\r\n1,3,core,"));
  CHECK(has(outcome.err, "variant 1 (radius=3), output core: "));
  const auto models = sweeps.models("");
  CHECK(models.size() == 3);
  REQUIRE(run({"eval", sweeps.at("ball.json"), "--output", "core", "--set", "radius=1", "-o", sweeps.at("alone.glb")})
              .code == 0);
  CHECK(models.at("core-1.glb") == contents(sweeps.at("alone.glb")));
  const Json variants = json_in(sweeps.at("r.json"))["variants"];
  REQUIRE(variants.size() == 4);
  CHECK(variants[1]["output"] == "core");
  CHECK(variants[3]["succeeded"] == false);
}

TEST_CASE("Four processes that are killed in the middle and started again make the same 200 files as one") {
  const Sweeps sweeps(120);
  const auto words = [&](const std::string& folder, const std::vector<std::string>& more) {
    std::vector<std::string> all = {"--grid", "radius=1:2:200", "--mkdir", "-o", sweeps.at(folder + "/{index}.glb")};
    all.insert(all.end(), more.begin(), more.end());
    return sweeps.words(all);
  };
  const auto start_parts = [&] {
    std::vector<std::unique_ptr<Program>> parts;
    for (const std::string index : {"0", "1", "2", "3"}) {
      parts.push_back(std::make_unique<Program>(
          words("parts", {"--index", index, "--count", "4", "--csv", sweeps.at(index + ".csv")})));
    }
    return parts;
  };
  // Where the machine wakes this test late they have made everything by then, and begin anew.
  std::size_t left_behind = 200;
  for (int tries = 0; left_behind == 200 && tries < 8; ++tries) {
    std::filesystem::remove_all(sweeps.at("parts"));
    {
      const auto parts = start_parts();
      REQUIRE(eventually([&] {
        return std::filesystem::exists(sweeps.at("parts/.dini-sweep.jsonl")) && sweeps.names("parts").size() > 8;
      }));
      for (const auto& part : parts) part->signal(SIGKILL);
    }
    left_behind = sweeps.names("parts").size();
  }
  CAPTURE(left_behind);
  REQUIRE(left_behind < 200);
  std::size_t lines = 0;
  std::string told;
  for (const auto& part : start_parts()) {
    const Outcome outcome = part->wait();
    CAPTURE(outcome.out, outcome.err);
    CHECK(outcome.code == 0);
    CHECK(has(outcome.out, "50 of 50 variants are done"));
    told += outcome.out;
  }
  CHECK(has(told, " of them by an earlier run"));
  for (const std::string index : {"0", "1", "2", "3"}) {
    const std::string table = contents(sweeps.at(index + ".csv"));
    lines += static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')) - 1;
  }
  CHECK(lines == 200);
  REQUIRE(Program(words("whole", {})).wait().code == 0);
  const auto whole = sweeps.models("whole");
  CHECK(whole.size() == 200);
  const bool same = whole == sweeps.models("parts");
  CHECK(same);
}

TEST_CASE("What is finished and right is not made again, what is missing or damaged is") {
  const Sweeps sweeps;
  const std::vector<std::string> words = {"--grid", "radius=1:2:4",    "-o", sweeps.at("{radius}.glb"),
                                          "--csv",  sweeps.at("m.csv")};
  REQUIRE(sweeps.sweep(words).code == 0);
  const std::string table = contents(sweeps.at("m.csv"));
  const auto models = sweeps.models("");
  CHECK(sweeps.sweep(words).out == "4 of 4 variants are done, 4 of them by an earlier run\n");
  CHECK(contents(sweeps.at("m.csv")) == table);
  std::filesystem::remove(sweeps.at("1.glb"));
  sweeps.write("2.glb", models.at("2.glb") + "x");
  CHECK(sweeps.sweep(words).out == "4 of 4 variants are done, 2 of them by an earlier run\n");
  CHECK(sweeps.models("") == models);
  sweeps.write("ball.json", segmented_ball(20).dump());
  CHECK(sweeps.sweep(words).out == "4 of 4 variants are done\n");
  CHECK(sweeps.models("") != models);
}

TEST_CASE("A sweep that was killed goes on where it was, and ends with the same files") {
  const Sweeps sweeps(400);
  const std::vector<std::string> grid = {"--grid", "radius=1:2:24", "--jobs", "1"};
  std::vector<std::string> killed = grid;
  killed.insert(killed.end(), {"-o", sweeps.at("killed/{radius}.glb"), "--mkdir"});
  {
    const Program program(sweeps.words(killed));
    REQUIRE(eventually([&] {
      return std::filesystem::exists(sweeps.at("killed/.dini-sweep.jsonl")) && !sweeps.names("killed").empty();
    }));
    program.signal(SIGKILL);
  }
  const Outcome resumed = sweeps.sweep(killed);
  CAPTURE(resumed.out);
  CHECK(resumed.code == 0);
  CHECK(has(resumed.out, "24 of 24 variants are done"));
  std::vector<std::string> whole = grid;
  whole.insert(whole.end(), {"-o", sweeps.at("whole/{radius}.glb"), "--mkdir"});
  REQUIRE(sweeps.sweep(whole).code == 0);
  CHECK(sweeps.models("killed") == sweeps.models("whole"));
}

TEST_CASE("A variant that fails is told with its values and does not stop the others") {
  const Sweeps sweeps;
  const Outcome outcome = sweeps.sweep({"--grid", "radius=-1:1:3", "--csv", "-"});
  CHECK(outcome.code == 3);
  CHECK(has(outcome.err, "ball.json: error: --set radius: variant 0 (radius=-1): "));
  CHECK(has(outcome.out, "\r\n0,-1,,out-of-range,,,,\r\n"));
  CHECK(has(outcome.out, "\r\n2,1,,ok,"));
  const Outcome fast = sweeps.sweep({"--grid", "radius=-1:1:3", "--report", "-", "--fail-fast", "--jobs", "1"});
  CHECK(fast.code == 3);
  CHECK(Json::parse(fast.out)["variants"].size() == 1);
  CHECK(Json::parse(fast.out)["succeeded"] == false);
}

TEST_CASE("Wrong calls of sweep are refused before anything is computed") {
  const Sweeps sweeps;
  for (const auto& [more, said] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{}, "--grid NAME=FROM:TO:COUNT or --list NAME=A,B"},
           {{"--grid", "radius"}, "--grid takes NAME=FROM:TO:COUNT"},
           {{"--grid", "radius=1:2"}, "--grid takes NAME=FROM:TO:COUNT"},
           {{"--grid", "radius=1:2:0"}, "--grid takes NAME=FROM:TO:COUNT"},
           {{"--grid", "radius=a:2:3"}, "--grid takes NAME=FROM:TO:COUNT"},
           {{"--list", "radius="}, "--list takes NAME=VALUE"},
           {{"--grid", "radius=1:2:3", "--list", "radius=1"}, "given twice"},
           {{"--grid", "radius=1:2:3", "--set", "radius=1"}, "is given by parameters as well"},
           {{"--grid", "radius=1:2:3", "-o", sweeps.at("x.glb")},
            "would be written twice; the name of each variant is its own with {index}"},
           {{"--grid", "radius=1:2:3", "-o", sweeps.at("{radiux}.glb")}, "did you mean \"radius\"?"},
           {{"--grid", "radius=1:2:3", "-o", sweeps.at("{radius}.dwg")}, "no format"},
           {{"--grid", "radius=1:2:3", "--csv", sweeps.at("ball.json")}, "which is read"},
           {{"--grid", "radius=1:2:3", "--output", "out", "--output", "out"}, "\"out\" is listed twice"},
           {{"--grid", "radius=1:2:3", "--index", "2", "--count", "2"}, "--index"},
           {{"--grid", "radius=1:2:3", "--count", "0"}, "--count"},
           {{"--grid", "radius=1:2:3", "--jobs", "0"}, "--jobs"},
           {{"--grid", "radius=1:2:3", "--csv", "-", "--report", "-"}, "written twice"}}) {
    const Outcome outcome = sweeps.sweep(more);
    CAPTURE(more, outcome.err);
    CHECK(outcome.code == 2);
    CHECK(has(outcome.err, said));
    CHECK(outcome.out.empty());
  }
  CHECK(sweeps.sweep({"--grid", "radius=1:2:100000"}).code == 5);
  CHECK(has(sweeps.sweep({"--grid", "radius=1:2:3", "--output", "ouz"}).err, "did you mean \"out\"?"));
  CHECK(sweeps.sweep({"--grid", "radius=1:2:3", "-o", sweeps.at("none/{radius}.glb")}).code == 6);
  CHECK(run({"sweep", "/nowhere.json", "--grid", "radius=1:2:3"}).code == 6);
}

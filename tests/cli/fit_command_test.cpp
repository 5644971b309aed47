// `dini fit`: what it is told, what it writes, and what it ends with.

#include "tests/cli/real_program.h"
#include "tests/support/documents.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

Json raised_ball() {
  Json graph = document(
      {{"ball", make("sphere_mesh", {{"radius", {{"parameter", "radius"}}}, {"center", {0, 0, 1}}, {"segments", 24}})},
       {"mass", make("measure", {{"model", from("ball")}})},
       {"out", make("export", {{"model", from("ball")}})}});
  graph["parameters"] = {{"radius", {{"type", "number"}, {"default", 1}, {"min", 0.1}, {"max", 3}}}};
  return graph;
}

struct Fits : Folder {
  Fits() { write("ball.json", raised_ball().dump()); }
  std::string at(const std::string& name) const { return (path() / name).string(); }
  Outcome run(std::vector<std::string> words) const {
    words.insert(words.begin(), DINI_PROGRAM);
    return Program(words).wait();
  }
  Outcome fit(std::vector<std::string> words) const {
    words.insert(words.begin(), {"fit", at("ball.json"), "--vary", "radius"});
    return run(words);
  }
  Json json(const std::string& name) const { return Json::parse(contents(path() / name)); }
};

}  // namespace

TEST_CASE("A ball takes the radius of the mesh that it is to be like, and the graph is written with it") {
  const Fits fits;
  const Outcome made = fits.run({"eval", fits.at("ball.json"), "--set", "radius=1.75", "-o", fits.at("scan.ply")});
  CAPTURE(made.err);
  REQUIRE(made.code == 0);
  const Outcome outcome =
      fits.fit({"--target-mesh", fits.at("scan.ply"), "-o", fits.at("best.json"), "--report", fits.at("fit.json")});
  CAPTURE(outcome.err, outcome.out);
  CHECK(outcome.code == 0);
  CHECK(outcome.out.starts_with("radius=1.7"));
  CHECK(std::abs(fits.json("best.json")["parameters"]["radius"]["default"].get<double>() - 1.75) < 1e-5);
  CHECK(fits.json("best.json")["nodes"] == raised_ball()["nodes"]);
  const Json report = fits.json("fit.json");
  CHECK(report["succeeded"] == true);
  CHECK(report["distance"]["largest"] < 1e-5);
  CHECK(fits.run({"eval", fits.at("best.json"), "-o", fits.at("best.glb")}).code == 0);
}

TEST_CASE("A volume that is asked for is met, within bounds, and one out of reach is not called met") {
  const Fits fits;
  const Outcome outcome = fits.fit({"--target", "mass.volume=2", "--report", "-"});
  CAPTURE(outcome.err, outcome.out);
  CHECK(outcome.code == 0);
  CHECK(Json::parse(outcome.out)["targets"]["mass.volume"]["found"] == Approx(2));
  const Outcome bounded = fits.run({"fit", fits.at("ball.json"), "--vary", "radius=0.2:0.4", "--target",
                                    "mass.volume=2", "--minimize", "mass.area"});
  CAPTURE(bounded.err, bounded.out);
  CHECK(bounded.code == 1);
  CHECK(bounded.out.find("nothing was found that keeps all targets") != std::string::npos);
}

TEST_CASE("Words that are no fit are refused before anything is read") {
  const Fits fits;
  CHECK(fits.fit({"--target", "mass.volume"}).code == 2);
  CHECK(fits.fit({"--target", "mass.volume=much"}).code == 2);
  CHECK(fits.run({"fit", fits.at("ball.json"), "--vary", "radius=1", "--target", "mass.volume=2"}).code == 2);
  CHECK(fits.run({"fit", fits.at("ball.json"), "--target", "mass.volume=2"}).code == 2);
  CHECK(fits.run({"fit", fits.at("ball.json"), "--vary", "size", "--target", "mass.volume=2"}).code == 3);
  CHECK(fits.fit({"--target", "mass.weight=2"}).code == 3);
  CHECK(fits.fit({"--target-mesh", fits.at("none.ply")}).code == 6);
  CHECK(fits.fit({}).code == 3);
  for (const char* bounds : {"nan:2", "0.2:nan", "0.2:inf", "1e999:2", ":2", "0.2:", ":", "0.2:1:2", "0.2"}) {
    CAPTURE(bounds);
    CHECK(
        fits.run({"fit", fits.at("ball.json"), "--vary", std::string("radius=") + bounds, "--target", "mass.volume=2"})
            .code == 2);
  }
  CHECK(fits.run({"fit", fits.at("ball.json"), "--vary", "radius=2:1", "--target", "mass.volume=2"}).code == 3);
  CHECK(fits.fit({"--target", "mass.volume=nan"}).code == 2);
  CHECK(fits.fit({"--target", "mass.volume=1e999"}).code == 2);
  CHECK(fits.fit({"--target", "mass.volume=2", "--target", "mass.volume=3"}).code == 2);
  CHECK(fits.fit({"--vary", "radius", "--target", "mass.volume=2"}).code == 2);
  CHECK(fits.fit({"--target", "mass.volume=2", "-o", fits.at("none/best.json")}).code == 6);
  CHECK(fits.fit({"--target", "mass.volume=2", "--set", "radius=9"}).code == 3);
}

TEST_CASE("A fit that cannot be done leaves a report that says why") {
  const Fits fits;
  const auto told = [&](std::vector<std::string> words) {
    fits.write("fit.json", R"({"succeeded": true})");
    words.insert(words.end(), {"--report", fits.at("fit.json")});
    const Outcome outcome = fits.run(words);
    CAPTURE(outcome.err);
    CHECK(outcome.code != 0);
    const Json report = fits.json("fit.json");
    CHECK(report["succeeded"] == false);
    return report["errors"][0]["code"].get<std::string>();
  };
  const std::string ball_file = fits.at("ball.json");
  CHECK(told({"fit", ball_file, "--vary", "size", "--target", "mass.volume=2"}) == "unknown-parameter");
  CHECK(told({"fit", ball_file, "--vary", "radius", "--target-mesh", fits.at("none.ply")}) == "io");
  CHECK(told({"fit", fits.at("none.json"), "--vary", "radius", "--target", "mass.volume=2"}) == "io");
  fits.write("points.obj", "v 0 0 0\nv 1 0 0\n");
  fits.write("empty.obj", "");
  fits.write("words.ply", "these are words\n");
  for (const char* file : {"points.obj", "empty.obj", "words.ply"}) {
    CAPTURE(file);
    CHECK_FALSE(told({"fit", ball_file, "--vary", "radius", "--target-mesh", fits.at(file)}).empty());
  }
}

TEST_CASE("The graph that a fit writes has the values that were given too") {
  const Fits fits;
  Json graph = raised_ball();
  graph["parameters"]["height"] = {{"type", "number"}, {"default", 1}};
  graph["nodes"]["tall"] = make("vector", {{"z", {{"parameter", "height"}}}});
  fits.write("tall.json", graph.dump());
  const Outcome outcome = fits.run({"fit", fits.at("tall.json"), "--set", "height=3", "--vary", "radius", "--target",
                                    "mass.volume=2", "-o", fits.at("best.json")});
  CAPTURE(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(fits.json("best.json")["parameters"]["height"]["default"] == 3);
}

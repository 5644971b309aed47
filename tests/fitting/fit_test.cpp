// Fits: what is found, what is told, and what is refused.

#include "fitting/fit.h"

#include <catch2/catch.hpp>

#include "tests/fitting/parameters.h"
#include "tests/support/requests.h"
#include "tests/support/shared_engine.h"

using namespace dini;
using namespace dini::support;

namespace {

Json parameter(const std::string& name) { return {{"parameter", name}}; }

/// A box of three edges: its volume and its area are products of them.
Json box() {
  Json graph = document(
      {{"volume", make("expression",
                       {{"formula", "x*y*z"}, {"x", parameter("a")}, {"y", parameter("b")}, {"z", parameter("c")}})},
       {"area", make("expression", {{"formula", "2*(x*y + y*z + z*x)"},
                                    {"x", parameter("a")},
                                    {"y", parameter("b")},
                                    {"z", parameter("c")}})}});
  graph["parameters"] = {{"a", number(1.7, 0.1, 4)},
                         {"b", number(0.6, 0.1, 4)},
                         {"c", number(1.1, 0.1, 4)},
                         {"paint", {{"type", "color"}, {"default", {1, 0, 0}}}},
                         {"free", {{"type", "number"}, {"default", 1}}}};
  return graph;
}

Json found(const FitRequest& request) {
  const Result<Json> answer = fitting::fit(engine(), request, Job());
  require_none(answer ? Problems() : answer.problems());
  return *answer;
}

FitRequest box_request() {
  return {.graph = engine().read(box()), .vary = {{"a", Json::array()}, {"b", Json::array()}, {"c", Json::array()}}};
}

std::string refusal(const FitRequest& request) {
  const Result<Json> answer = fitting::fit(engine(), request, Job());
  REQUIRE_FALSE(answer);
  const Problem& problem = answer.problems().front();
  return problem.code + " " + problem.pointer.value_or("");
}

}  // namespace

TEST_CASE("Of all boxes of one volume the cube has the least area") {
  FitRequest request = box_request();
  request.targets = {{"volume", 0.8}};
  request.minimize = {"area"};
  const Json answer = found(request);
  CAPTURE(answer.dump(1));
  CHECK(answer["outcome"] == "converged");
  for (const char* edge : {"a", "b", "c"}) CHECK(answer["parameters"][edge] == Approx(std::cbrt(0.8)).epsilon(1e-5));
  CHECK(answer["targets"]["volume"]["found"] == Approx(0.8).epsilon(1e-8));
  CHECK(answer["minimized"]["area"] == Approx(6 * std::cbrt(0.64)).epsilon(1e-8));
  CHECK(answer["undetermined"].empty());
}

TEST_CASE("Bounds are kept, and a parameter that ends at one is named") {
  FitRequest request = box_request();
  request.vary["a"] = {1.5, 2};
  request.targets = {{"volume", 0.8}};
  request.minimize = {"area"};
  const Json answer = found(request);
  CAPTURE(answer.dump(1));
  CHECK(answer["parameters"]["a"] == 1.5);
  CHECK(answer["at_bounds"] == Json{"a"});
  CHECK(answer["parameters"]["b"] == Approx(std::sqrt(0.8 / 1.5)).epsilon(1e-5));
}

TEST_CASE("A target that many settings meet is met, and says which parameters it does not determine") {
  FitRequest request = box_request();
  request.targets = {{"volume", 0.8}};
  const Json answer = found(request);
  CAPTURE(answer.dump(1));
  CHECK(answer["targets"]["volume"]["found"] == Approx(0.8).epsilon(1e-9));
  CHECK(answer["undetermined"].size() == 2);
}

TEST_CASE("A parameter that nothing depends on is undetermined by name") {
  FitRequest request = box_request();
  request.vary["free"] = {0, 2};
  request.targets = {{"volume", 0.8}, {"area", 5.4}};
  request.minimize = {"a"};
  request.minimize.clear();
  const Json answer = found(request);
  CAPTURE(answer.dump(1));
  bool named = false;
  for (const Json& each : answer["undetermined"]) named = named || each["parameters"] == Json{"free"};
  CHECK(named);
}

TEST_CASE("The same request has the same answer, digit by digit") {
  FitRequest request = box_request();
  request.targets = {{"volume", 0.8}, {"area", 6}};
  CHECK(found(request) == found(request));
}

TEST_CASE("Several starts find the valley that the first one is not in") {
  Json graph =
      document({{"height", make("expression", {{"formula", "(x*x - 1)*(x*x - 1) + 0.3*x"}, {"x", parameter("x")}})}});
  graph["parameters"] = {{"x", number(0.9, -2, 2)}};
  FitRequest request{.graph = engine().read(graph), .vary = {{"x", Json::array()}}, .minimize = {"height"}};
  request.starts = 1;
  CHECK(found(request)["parameters"]["x"] > 0.5);
  request.starts = 4;
  CHECK(found(request)["parameters"]["x"] < -0.5);
}

TEST_CASE("No more evaluations are made than are allowed, and the best of them is told") {
  FitRequest request = box_request();
  request.targets = {{"volume", 0.8}, {"area", 6}};
  for (const std::int64_t most : {1, 2, 4, 5, 17, 40}) {
    request.evaluations = most;
    const Json answer = found(request);
    CAPTURE(most, answer.dump(1));
    CHECK(answer["outcome"] == "evaluations");
    CHECK(answer["evaluations"] <= most);
    CHECK(answer["parameters"].size() == 3);
    CHECK_FALSE(answer["starts"].empty());
  }
}

TEST_CASE("A place may be wanted twice, as a target and as what is to be small") {
  FitRequest request = box_request();
  request.targets = {{"volume", 0.8}};
  request.minimize = {"area", "volume", "area"};
  const Json answer = found(request);
  for (const char* edge : {"a", "b", "c"}) CHECK(answer["parameters"][edge] == Approx(std::cbrt(0.8)).epsilon(1e-4));
  CHECK(answer["minimized"]["volume"] == answer["targets"]["volume"]["found"]);
}

TEST_CASE("A default out of the bounds in which it varies begins at the nearest one") {
  FitRequest request = box_request();
  request.vary = {{"a", {2, 3}}};
  request.targets = {{"volume", 1.5}};
  const Json answer = found(request);
  CHECK(answer["starts"][0]["from"]["a"] == 2);
  CHECK(answer["parameters"]["a"] == Approx(1.5 / 0.66));
}

TEST_CASE("More conditions than parameters are kept beside what is to be small, where they can be") {
  Json graph = document({{"line", make("range", {{"from", parameter("a")}, {"to", parameter("b")}, {"count", 100}})},
                         {"size", make("expression", {{"formula", "x*x"}, {"x", parameter("c")}})}});
  graph["parameters"] = {{"a", number(0.3, -1, 4)}, {"b", number(2, -1, 4)}, {"c", number(1, -3, 3)}};
  Json wanted = Json::array();
  for (int k = 0; k < 100; ++k) wanted.push_back(1 + 2 * k / 99.0);
  FitRequest request{.graph = engine().read(graph),
                     .vary = {{"a", Json::array()}, {"b", Json::array()}, {"c", Json::array()}},
                     .targets = {{"line", wanted}},
                     .minimize = {"size"}};
  const Json answer = found(request);
  CAPTURE(answer["outcome"], answer["parameters"].dump());
  CHECK(answer["outcome"] == "converged");
  CHECK(answer["parameters"]["a"] == Approx(1).epsilon(1e-5));
  CHECK(answer["parameters"]["b"] == Approx(3).epsilon(1e-5));
  CHECK(std::abs(answer["parameters"]["c"].get<double>()) < 1e-3);
  request.targets["line"][50] = 7;
  CHECK(found(request)["outcome"] == "conditions");
}

TEST_CASE("A deadline ends a fit with the best so far") {
  FitRequest request = box_request();
  request.targets = {{"volume", 0.8}};
  const Result<Json> answer =
      fitting::fit(engine(), request, Job(), {.deadline = Cancel::Clock::now(), .improved = {}});
  REQUIRE(answer);
  CHECK((*answer)["outcome"] == "deadline");
  CHECK((*answer)["evaluations"] == 1);
  CHECK((*answer)["parameters"] == Json{{"a", 1.7}, {"b", 0.6}, {"c", 1.1}});
  // One that comes within the first evaluation leaves nothing.
  const Result<Json> none =
      fitting::fit(engine(), request, Job{.cancel = Cancel(Cancel::Clock::now()), .progress = {}});
  REQUIRE_FALSE(none);
  CHECK(none.problems().front().code == "deadline");
}

TEST_CASE("The best so far only gets better while it is told, and is the answer in the end") {
  FitRequest request = box_request();
  request.targets = {{"volume", 0.8}, {"area", 6}};
  std::vector<Json> told;
  const Result<Json> answer =
      fitting::fit(engine(), request, Job(), {.improved = [&](const Json& best) { told.push_back(best); }});
  REQUIRE(answer);
  REQUIRE(told.size() > 2);
  for (std::size_t i = 1; i < told.size(); ++i) CHECK(told[i]["objective"] < told[i - 1]["objective"]);
  CHECK(told.back()["parameters"] == (*answer)["parameters"]);
}

TEST_CASE("A canceled fit ends with the reason") {
  FitRequest request = box_request();
  request.targets = {{"volume", 0.8}};
  Job job;
  job.cancel.stop(StopReason::canceled);
  const Result<Json> answer = fitting::fit(engine(), request, job);
  REQUIRE_FALSE(answer);
  CHECK(answer.problems().front().code == "canceled");
}

TEST_CASE("What is wrong with a fit is told at its place") {
  const auto changed = [](auto change) {
    FitRequest request = box_request();
    request.targets = {{"volume", 0.8}};
    change(request);
    return refusal(request);
  };
  CHECK(changed([](FitRequest& r) { r.targets = Json::object(); }) == "required-input-missing ");
  CHECK(changed([](FitRequest& r) { r.vary = Json::object(); }) == "required-input-missing /vary");
  CHECK(changed([](FitRequest& r) { r.vary["d"] = Json::array(); }) == "unknown-parameter /vary/d");
  CHECK(changed([](FitRequest& r) { r.vary["paint"] = Json::array(); }) == "type-mismatch /vary/paint");
  CHECK(changed([](FitRequest& r) { r.vary["free"] = Json::array(); }) == "required-input-missing /vary/free");
  CHECK(changed([](FitRequest& r) { r.vary["a"] = {0, 2}; }) == "out-of-range /vary/a");
  CHECK(changed([](FitRequest& r) { r.vary["a"] = {2, 1}; }) == "out-of-range /vary/a");
  CHECK(changed([](FitRequest& r) { r.vary["a"] = 3; }) == "type-mismatch /vary/a");
  CHECK(changed([](FitRequest& r) { r.vary["free"] = {-1.7e308, 1.7e308}; }) == "out-of-range /vary/free");
  CHECK(changed([](FitRequest& r) { r.parameters = {{"a", 5}}; }) == "out-of-range /parameters/a");
  CHECK(changed([](FitRequest& r) { r.parameters = {{"a", "much"}}; }) == "type-mismatch /parameters/a");
  CHECK(changed([](FitRequest& r) {
          r.vary["a"] = {1, 2};
          r.parameters = {{"a", 3}};
        }) == "out-of-range /parameters/a");
  CHECK(changed([](FitRequest& r) { r.targets["volume"] = "big"; }) == "type-mismatch /targets/volume");
  CHECK(changed([](FitRequest& r) { r.targets["volume"] = {1, 2}; }) == "axis-mismatch /targets/volume");
  CHECK(changed([](FitRequest& r) { r.targets["weight"] = 1; }) == "unknown-node /targets/weight");
  CHECK(changed([](FitRequest& r) { r.target_mesh = "none.ply"; }) == "unknown-output /mesh");
  CHECK(changed([](FitRequest& r) {
          r.target_mesh = "none.ply";
          r.mesh = "volume";
        }) == "unknown-asset /target_mesh");
  CHECK(changed([](FitRequest& r) { r.mesh = "volume"; }) == "required-input-missing /mesh");
}

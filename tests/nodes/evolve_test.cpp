// Networks of points in graphs: which points are neighbors, and which axes there are.

#include <tbb/global_control.h>

#include "graph/cost.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"

using namespace dini;
using namespace dini::support;

namespace {

const Json crowd = {{"crowd", make("random", {{"count", 300}, {"axis", "body"}})}};

CatalogueGraph evolved(Json inputs, Json others = crowd) {
  if (!inputs.contains("points")) inputs["points"] = from("crowd.points");
  others["it"] = make("evolve", std::move(inputs));
  return graph_of(others);
}

/// Four points at the corners of a square, over a closed or an open axis.
Json square(bool closed) {
  return {{"ring", make("circle")},
          {"square", make("sample", {{"shape", from("ring")}, {"count", 4}, {"closed", closed}})}};
}

}  // namespace

TEST_CASE("The rows of a network run over the steps and over the axis of the points") {
  CatalogueGraph graph = evolved({{"steps", 7}, {"axis", "time"}});
  CHECK(graph.planned("it").outputs[0].axes == Axes{{"time", 7, false}, {"body", 300, false}});
  const std::vector<Point> rows = graph.all<Point>("it"), start = graph.all<Point>("crowd.points");
  REQUIRE(rows.size() == 7 * 300);
  CHECK(std::equal(start.begin(), start.end(), rows.begin()));
  CHECK(evolved({{"points", from("square")}, {"steps", 3}}, square(true)).planned("it").outputs[0].axes[1].closed);
}

TEST_CASE("An axis of steps may not be called as that of the points") {
  const Problems problems = evolved({{"axis", "body"}}).static_problems();
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].code == "axis-mismatch");
  CHECK(problems[0].port == "axis");
}

TEST_CASE("A network of many nearest neighbors is that of all") {
  const Json few = {{"crowd", make("random", {{"count", 20}, {"axis", "body"}})}};
  const std::vector<Point> all = evolved({{"neighbors", "all"}, {"steps", 5}}, few).all<Point>("it");
  const std::vector<Point> nearest = evolved({{"count", 19}, {"steps", 5}}, few).all<Point>("it");
  REQUIRE(all.size() == nearest.size());
  for (std::size_t i = 0; i < all.size(); ++i) require_close(all[i], nearest[i], 1e-13);
  CHECK_FALSE(all[99] == evolved({{"count", 3}, {"steps", 5}}, few).all<Point>("it")[99]);
}

TEST_CASE("A chain joins the points of an axis, around if it is closed, as links do that say the same") {
  const auto last = [](Json inputs, bool closed) {
    inputs["points"] = from("square");
    inputs["steps"] = 4;
    return evolved(inputs, square(closed)).all<Point>("it");
  };
  CHECK(last({{"neighbors", "chain"}}, true) == last({{"neighbors", "links"}, {"links", "3-0 0-1, 1-2 2-3"}}, true));
  const std::vector<Point> open = last({{"neighbors", "chain"}}, false);
  const std::vector<Point> linked = last({{"neighbors", "links"}, {"links", "0-1 1-2 2-3"}}, false);
  for (std::size_t i = 0; i < open.size(); ++i) require_close(open[i], linked[i], 1e-14);
  const std::vector<Point> none = last({{"neighbors", "links"}}, true);
  CHECK(none[12] == none[0]);
}

TEST_CASE("A pair of points that is named twice is joined once, in links and in a chain of two") {
  const auto last = [](Json inputs, Json others) {
    inputs.update({{"points", from("square")}, {"steps", 4}});
    return evolved(inputs, std::move(others)).all<Point>("it");
  };
  const auto linked = [&](const char* links) { return last({{"neighbors", "links"}, {"links", links}}, square(true)); };
  CHECK(linked("0-1 1-0 0-1 2-2 1-2") == linked("0-1 1-2"));
  Json two = square(true);
  two["square"]["inputs"]["count"] = 2;
  CHECK(last({{"neighbors", "chain"}}, two) == last({{"neighbors", "links"}, {"links", "0-1"}}, two));
}

TEST_CASE("The memory of links is that of a table with room for the point that has most of them") {
  const auto bytes = [](const std::string& links) {
    const Json others = {{"crowd", make("random", {{"count", 100'000}, {"axis", "body"}})}};
    return cost_of(evolved({{"neighbors", "links"}, {"links", links}, {"steps", 1}}, others).planned("it")).run_bytes;
  };
  std::string star;
  for (int k = 1; k <= 64; ++k) star += " 0-" + std::to_string(k);
  CHECK(bytes(star) - bytes("0-1") >= 4 * 63 * 100'000.0);
}

TEST_CASE("Links that cannot be read, and points that are not there, are told") {
  const auto problem = [](const std::string& links) {
    CatalogueGraph graph =
        evolved({{"points", from("square")}, {"neighbors", "links"}, {"links", links}}, square(true));
    const Problems problems = graph.problems("it");
    return problems.empty() ? "" : problems.front().code + " at " + problems.front().port;
  };
  CHECK(problem("0-1 1-2") == "");
  for (const char* wrong : {"0", "0-", "a-b", "0-1-2", "0 - 1", "-1-2", "0-1;1-2", "0-99999999999"}) {
    CAPTURE(wrong);
    CHECK(problem(wrong) == "invalid-links at links");
  }
  CHECK(problem("0-4") == "out-of-range at links");
}

TEST_CASE("A point at infinity has no neighbors, which is an error") {
  const Json others = {{"o", make("point")},
                       {"ball", make("sphere")},
                       {"far", make("reflect", {{"shape", from("o")}, {"mirror", from("ball")}})},
                       {"both", make("list", {{"items", {from("o"), from("far")}}})}};
  const Problems problems = evolved({{"points", from("both")}}, others).problems("it");
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].code == "degenerate");
  CHECK(problems[0].port == "points");
}

TEST_CASE("A network is the same with one thread and with eight") {
  const Json inputs = {{"steps", 12}, {"rest", 0.2}, {"damping", 0.3}, {"strength", 0.5}};
  std::vector<std::vector<Point>> results;
  for (const std::size_t threads : {1, 2, 8}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    results.push_back(evolved(inputs).all<Point>("it"));
  }
  CHECK(results[0] == results[1]);
  CHECK(results[0] == results[2]);
}

TEST_CASE("Weights may differ from point to point, and decide who goes where") {
  Json others = crowd;
  others["weight"] = make("list", {{"items", {0, 1, 2}}, {"axis", "three"}});
  others["three"] = make("list", {{"items", {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}}}, {"axis", "three"}});
  const std::vector<Point> rows = evolved({{"points", from("three")},
                                           {"weights", from("weight")},
                                           {"steps", 2},
                                           {"neighbors", "all"},
                                           {"strength", 0.01}},
                                          others)
                                      .all<Point>("it");
  CHECK(rows[3].x > -1);
  CHECK(rows[4] == Point{0, 0, 0});
  CHECK(rows[5].x > 1);
}

// A graph with groups is the same graph as its flat form, to everything that is made of it.

#include <catch2/catch.hpp>

#include "service/graph_difference.h"
#include "service/graph_merge.h"
#include "tests/support/requests.h"
#include "tests/support/shared_engine.h"

using namespace dini;
using namespace dini::support;

namespace {

/// Boosted rings within a frame that turns them: two groups, one in the other, the inner one standing twice.
Json nested() {
  return Json::parse(R"({
    "format": 2,
    "parameters": {"reach": {"type": "number", "default": 1, "min": 0, "max": 4}},
    "groups": {
      "petal": {
        "inputs": [{"name": "reach", "default": 0.5}, {"name": "generator"}, {"name": "count", "default": 6}],
        "outputs": [{"name": "mesh", "from": "skin"}, {"name": "rings", "from": "boosted.shape"}],
        "nodes": {
          "ring": {"type": "circle", "inputs": {"radius": 1}},
          "k": {"type": "range", "inputs": {"from": 0, "to": {"input": "reach"}, "count": {"input": "count"}}},
          "boosted": {"type": "boost", "inputs": {"shape": {"from": "ring"}, "generator": {"input": "generator"}, "amount": {"from": "k"}}},
          "skin": {"type": "surface", "inputs": {"shape": {"from": "boosted"}, "segments": 12}}
        }
      },
      "flower": {
        "inputs": [{"name": "reach"}],
        "outputs": [{"name": "low", "from": "one"}, {"name": "high", "from": "two.mesh"}],
        "nodes": {
          "tau": {"type": "point_pair", "inputs": {"position": [0, 0, 1.5], "direction": [0, 0, 1]}},
          "one": {"type": "group/petal", "inputs": {"generator": {"from": "tau"}}},
          "two": {"type": "group/petal", "inputs": {"generator": {"from": "tau"}, "reach": {"input": "reach"}, "count": 4}}
        }
      }
    },
    "nodes": {
      "flower": {"type": "group/flower", "inputs": {"reach": {"parameter": "reach"}}},
      "out": {"type": "export", "inputs": {"model": [{"from": "flower.low"}, {"from": "flower.high"}]}}
    }
  })");
}

Json flat() {
  return Json::parse(R"({
    "format": 2,
    "parameters": {"reach": {"type": "number", "default": 1, "min": 0, "max": 4}},
    "nodes": {
      "flower/tau": {"type": "point_pair", "inputs": {"position": [0, 0, 1.5], "direction": [0, 0, 1]}},
      "flower/one/ring": {"type": "circle", "inputs": {"radius": 1}},
      "flower/one/k": {"type": "range", "inputs": {"from": 0, "to": 0.5, "count": 6}},
      "flower/one/boosted": {"type": "boost", "inputs": {"shape": {"from": "flower/one/ring"}, "generator": {"from": "flower/tau"}, "amount": {"from": "flower/one/k"}}},
      "flower/one/skin": {"type": "surface", "inputs": {"shape": {"from": "flower/one/boosted"}, "segments": 12}},
      "flower/two/ring": {"type": "circle", "inputs": {"radius": 1}},
      "flower/two/k": {"type": "range", "inputs": {"from": 0, "to": {"parameter": "reach"}, "count": 4}},
      "flower/two/boosted": {"type": "boost", "inputs": {"shape": {"from": "flower/two/ring"}, "generator": {"from": "flower/tau"}, "amount": {"from": "flower/two/k"}}},
      "flower/two/skin": {"type": "surface", "inputs": {"shape": {"from": "flower/two/boosted"}, "segments": 12}},
      "out": {"type": "export", "inputs": {"model": [{"from": "flower/one/skin"}, {"from": "flower/two/skin"}]}}
    }
  })");
}

Json errors_of(const Json& graph) {
  return engine().validate(*engine().read(graph), Json::object(), Cancel()).value()["errors"];
}

OrderedJson ordered(const Json& json) { return OrderedJson::parse(json.dump()); }

}  // namespace

TEST_CASE("A graph with two nested groups makes the bytes, tags and fingerprints of its flat form") {
  for (const Json& parameters : {Json::object(), Json{{"reach", 2.5}}}) {
    const Asked asked{.graph = nested(), .parameters = parameters}, same{.graph = flat(), .parameters = parameters};
    CHECK(file_of(engine(), asked) == file_of(engine(), same));
    CHECK(prepared_for(engine(), asked).value()->model_tag == prepared_for(engine(), same).value()->model_tag);
  }
}

TEST_CASE("What stands at an output of a group is looked at by the id of the instance") {
  CHECK(inspected(engine(), nested(), "flower.high") == inspected(engine(), flat(), "flower/two/skin"));
  CHECK(inspected(engine(), nested(), "flower/two.rings") == inspected(engine(), flat(), "flower/two/boosted"));
  CHECK(inspected(engine(), nested(), "flower/one/k") == inspected(engine(), flat(), "flower/one/k.values"));
  const auto drawn = prepared_for(engine(), {.graph = nested(), .preview = {"flower/two"}});
  REQUIRE(drawn);
  const auto same = prepared_for(engine(), {.graph = flat(), .preview = {"flower/two/skin", "flower/two/boosted"}});
  CHECK((*drawn)->model_tag == (*same)->model_tag);
}

TEST_CASE("A group may make the file, which is asked for by the instance or by the node in it") {
  Json graph = nested();
  graph["groups"]["flower"]["nodes"]["file"] = make("export", {{"model", from("one")}});
  graph["groups"]["flower"]["outputs"].push_back({{"name", "file"}, {"from", "file"}});
  graph["nodes"].erase("out");
  const std::string file = file_of(engine(), {.graph = graph});
  CHECK(file_of(engine(), {.graph = graph, .output = "flower/file"}) == file);
  CHECK(file_of(engine(), {.graph = graph, .output = "flower.file"}) == file);
}

TEST_CASE("A place that is not there is told by what was asked for") {
  Json graph = nested();
  graph["groups"]["flower"]["nodes"]["file"] = make("export", {{"model", from("one")}});
  graph["groups"]["flower"]["outputs"].push_back({{"name", "file"}, {"from", "file.asset"}});
  graph["nodes"].erase("out");
  const auto told = [&](const Asked& asked) {
    const auto refused = prepared_for(engine(), asked);
    REQUIRE_FALSE(refused);
    const Problem& problem = refused.problems().front();
    return problem.code + " " + problem.pointer.value_or("") + ": " + problem.detail;
  };
  CHECK(told({.graph = graph, .measures = {"flower.hihg"}}) ==
        "unknown-port /measures/0: flower, an instance of a group, has no output \"hihg\"; did you mean \"high\"?");
  CHECK(told({.graph = graph, .preview = {"flower.x"}}).starts_with("unknown-port /preview/0: flower, an instance"));
  CHECK(told({.graph = graph, .output = "flower.low"})
            .starts_with("unknown-output /output: \"flower.low\" is no export node of the graph"));
  CHECK(told({.graph = graph, .output = "flower/file.nonsense"}).starts_with("unknown-output /output"));
  const std::string file = file_of(engine(), {.graph = graph});
  // Named alone, an instance means that of its outputs which is a file.
  CHECK(file_of(engine(), {.graph = graph, .output = "flower"}) == file);
  CHECK(file_of(engine(), {.graph = graph, .output = "flower.file"}) == file);
}

TEST_CASE("A problem in a group is told with the id of its node and its place in the document") {
  Json graph = nested();
  graph["groups"]["petal"]["nodes"]["skin"]["inputs"]["segments"] = -3;
  const Json errors = errors_of(graph);
  REQUIRE(errors.size() == 2);
  CHECK(errors[0]["node"] == "flower/one/skin");
  CHECK(errors[1]["node"] == "flower/two/skin");
  for (const Json& error : errors) CHECK(error["pointer"] == "/graph/groups/petal/nodes/skin/inputs/segments");
  graph = nested();
  graph["groups"]["flower"]["nodes"]["two"]["inputs"]["count"] = 0;
  REQUIRE(errors_of(graph).size() == 1);
  CHECK(errors_of(graph)[0]["node"] == "flower/two/k");
  CHECK(errors_of(graph)[0]["pointer"] == "/graph/groups/flower/nodes/two/inputs/count");
}

TEST_CASE("A file that carries its graph carries the groups") {
  Json graph = nested();
  const Asked asked{.graph = graph, .embed_graph = true};
  const std::string file = file_of(engine(), asked);
  CHECK(file.find(R"("group/petal")") != std::string::npos);
  graph["meta"] = {{"title", "Flower"}};
  CHECK(engine().read(graph) == engine().read(nested()));
  CHECK(engine().read(graph)->hash != engine().read(flat())->hash);
}

TEST_CASE("A difference tells what changed in groups as it tells what changed in the document") {
  Json after = nested();
  Json& petal = after["groups"]["petal"];
  petal["nodes"]["skin"]["inputs"]["segments"] = 24;
  petal["label"] = "Petal";
  after["groups"]["stem"] = {{"nodes", Json::object()}};
  const Json found = graph_difference(nested(), after);
  CHECK(found["nodes"]["changed"].empty());
  CHECK(found["groups"]["added"] == Json{"stem"});
  CHECK(found["groups"]["changed"]["petal"] ==
        Json{{"label", {{"to", "Petal"}}},
             {"nodes",
              {{"added", Json::array()},
               {"removed", Json::array()},
               {"changed", {{"skin", {{"inputs", {{"segments", {{"from", 12}, {"to", 24}}}}}}}}}}}});
  CHECK_FALSE(graph_difference(document({}), document({})).contains("groups"));
}

TEST_CASE("Two sides that changed different things in a group merge, and the same input conflicts") {
  Json ours = nested(), theirs = nested();
  ours["groups"]["petal"]["nodes"]["skin"]["inputs"]["segments"] = 24;
  theirs["groups"]["petal"]["nodes"]["ring"]["inputs"]["radius"] = 2;
  const GraphMerge merge = merge_graphs(ordered(nested()), ordered(ours), ordered(theirs));
  CHECK(merge.conflicts.empty());
  Json both = ours;
  both["groups"]["petal"]["nodes"]["ring"]["inputs"]["radius"] = 2;
  CHECK(Json::parse(merge.merged.dump()) == both);
  ours["groups"]["petal"]["nodes"]["ring"]["inputs"]["radius"] = {{"input", "reach"}};
  const Problems conflicts = merge_graphs(ordered(nested()), ordered(ours), ordered(theirs)).conflicts;
  REQUIRE(conflicts.size() == 1);
  CHECK(conflicts[0].pointer == "/groups/petal/nodes/ring/inputs/radius");
  CHECK(conflicts[0].node.empty());
}

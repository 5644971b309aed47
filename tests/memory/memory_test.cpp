// What is predicted to be needed bounds what is needed, and is not much more.

#include <catch2/catch.hpp>
#include <random>

#include "tests/memory/memory_meter.h"
#include "tests/nodes/large_graphs.h"

using namespace dini;
using namespace dini::support;

namespace {

/// Below so many bytes what does not grow with a graph counts most.
constexpr std::size_t much = 2'500'000;

struct Memory {
  std::size_t predicted = 0;
  std::size_t used = 0;
};

/// The plan of one node and all that it needs, within so much work.
CheckReport planned(const Json& nodes, const std::string& node, std::size_t work) {
  const Result<Document> read = read_document(document(nodes), Limits{}, catalogue());
  REQUIRE(read);
  Limits limits;
  limits.work = work;
  return check(catalogue(), *read, {}, Quality::final, limits, test_file, {{node}, false});
}

/// The memory of an evaluation of one node and all that it needs.
Memory memory_of(const Json& nodes, const std::string& node) {
  const CheckReport report = planned(nodes, node, Limits().work);
  for (const Problem& problem : report.problems) FAIL(problem.code << " at " << problem.node << ": " << problem.detail);
  Cache cache(std::size_t{4} << 30);
  const Job job;
  restart_memory_meter();
  const Result<Evaluation> evaluation = evaluate(report.plan, {report.plan.index.at(node)}, cache, job);
  const std::size_t used = most_memory();
  for (const Problem& problem : evaluation ? Problems{} : evaluation.problems()) {
    // Too many of something that only the run can count; what was used until then counts.
    if (problem.code == "limit-exceeded") continue;
    FAIL(problem.code << " at " << problem.node << ": " << problem.detail);
  }
  return {report.plan.cost.bytes, used};
}

void check_prediction(const Json& nodes, const std::string& node) {
  const Memory memory = memory_of(nodes, node);
  CAPTURE(memory.predicted, memory.used);
  CHECK(memory.used <= memory.predicted);
  if (memory.used > much) CHECK(memory.predicted <= 4 * memory.used);
}

/// Adds a random mesh and a random way on from it; the id of the last node.
std::string add_random_mesh(Json& nodes, const std::string& prefix, std::mt19937& random) {
  const std::size_t side = 60 + random() % 240;
  std::string last = prefix + "source";
  switch (random() % 4) {
    case 0:
      nodes[last] = make("sphere_mesh", {{"segments", side}, {"rings", side}});
      break;
    case 1:
      nodes[last] = make("box_mesh", {{"segments", side / 3}});
      break;
    case 2:
      nodes[prefix + "grid"] = make("grid", {{"count_u", side}, {"count_v", side}});
      nodes[last] = make("surface", {{"shape", from(prefix + "grid.points")}, {"clip_radius", 1.3}});
      break;
    default:
      nodes[prefix + "ring"] = make("circle");
      nodes[last] = make("tube", {{"shape", from(prefix + "ring")}, {"segments", 10 * side}, {"sides", 24}});
  }
  for (std::size_t step = 0, steps = random() % 4; step < steps; ++step) {
    const std::string next = prefix + "step" + std::to_string(step);
    const Json shape = from(last);
    const std::vector<Json> ways = {
        make("translate", {{"shape", shape}, {"vector", {1, 0, 0}}}),
        make("boost", {{"shape", shape}, {"generator", from("pair")}, {"amount", 0.1}}),
        make("warp", {{"shape", shape}, {"generators", {from("pair"), from("pair")}}, {"softening", 1}}),
        make("curvature_color", {{"shape", shape}}),
        make("color", {{"shape", shape}}),
        make("subdivide", {{"shape", shape}}),
        make("merge", {{"meshes", {shape, shape}}}),
    };
    nodes[next] = ways[random() % ways.size()];
    last = next;
  }
  return last;
}

void check_nodes(std::size_t quarter) {
  // What would take long for much is given little: some seconds of work are enough for one node.
  constexpr std::size_t most_work = 2'000'000'000;
  for (const Subject& subject : quarter_of_subjects(quarter)) {
    for (const std::size_t size : {50'000, 2000}) {
      for (const Json& nodes : large_graphs(subject, size)) {
        CAPTURE(subject.name(), nodes.dump());
        if (planned(nodes, "subject", most_work).problems.empty()) check_prediction(nodes, "subject");
      }
    }
  }
}

}  // namespace

TEST_CASE("The memory of every node is within what is predicted, and not far below: first quarter") { check_nodes(0); }

TEST_CASE("The memory of every node is within what is predicted, and not far below: second quarter") { check_nodes(1); }

TEST_CASE("The memory of every node is within what is predicted, and not far below: third quarter") { check_nodes(2); }

TEST_CASE("The memory of every node is within what is predicted, and not far below: last quarter") { check_nodes(3); }

TEST_CASE("The memory of random graphs with an export is within what is predicted, and not far below") {
  std::mt19937 random(1717);
  for (int graph = 0; graph < 25; ++graph) {
    Json nodes = {{"pair", make("point_pair", {{"position", {3, 1, 0}}})}};
    Json models = Json::array();
    for (std::size_t part = 0, parts = 1 + random() % 3; part < parts; ++part) {
      models.push_back(from(add_random_mesh(nodes, "p" + std::to_string(part) + "_", random)));
    }
    nodes["out"] = make("export", {{"model", models}});
    CAPTURE(graph, nodes.dump());
    check_prediction(nodes, "out");
  }
}

TEST_CASE("An export of very many circles is predicted, and takes a fraction of a gigabyte") {
  const Json nodes = {{"places", make("random", {{"count", 400'000}})},
                      {"rings", make("circle", {{"center", from("places.points")}})},
                      {"out", make("export", {{"model", from("rings")}})}};
  const Memory memory = memory_of(nodes, "out");
  CAPTURE(memory.predicted, memory.used);
  CHECK(memory.used <= memory.predicted);
  CHECK(memory.predicted <= 4 * memory.used);
  CHECK(memory.used < 600'000'000);
}

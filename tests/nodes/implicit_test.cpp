#include <catch2/catch.hpp>
#include <fstream>

#include "algebra/versor.h"
#include "geometry/measure.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"
#include "tests/support/never_stopped.h"
#include "tests/support/random_elements.h"

using namespace dini;
using namespace dini::support;

namespace {

Json ball_and_ring() {
  return {{"ball", make("sphere", {{"radius", 0.8}})},
          {"ring", make("circle", {{"radius", 0.9}, {"normal", {0.2, 0, 1}}})},
          {"tau", make("point_pair", {{"position", {0.4, 0, 1.6}}, {"direction", {0.1, 0.2, 0.3}}})},
          {"a", make("solid", {{"shape", from("ball")}})},
          {"b", make("around", {{"shape", from("ring")}, {"distance", 0.25}})}};
}

Json read_example(const std::string& id) {
  std::ifstream file(std::string(DINI_SOURCE_DIR) + "/examples/" + id + ".json");
  return Json::parse(file);
}

/// The nodes of a document with numbers instead of its parameters.
Json with_numbers(Json nodes, const Json& numbers) {
  for (auto& [id, node] : nodes.items()) {
    for (auto& [port, input] : node["inputs"].items()) {
      if (input.is_object() && input.contains("parameter")) {
        input = Json(numbers[input["parameter"].get<std::string>()]);
      }
    }
  }
  return nodes;
}

}  // namespace

TEST_CASE("A field that was boosted has its surface where the boosted shape is") {
  Json nodes = ball_and_ring();
  nodes["boosted_ball"] = make("boost", {{"shape", from("ball")}, {"generator", from("tau")}, {"amount", 0.7}});
  nodes["shape_first"] = make("solid", {{"shape", from("boosted_ball")}});
  nodes["field_first"] = make("boost", {{"shape", from("a")}, {"generator", from("tau")}, {"amount", 0.7}});
  nodes["places"] = make("random", {{"count", 200}, {"minimum", {-2, -2, -2}}, {"maximum", {2, 2, 2}}});
  for (const char* field : {"shape_first", "field_first"}) {
    nodes[std::string("at_") + field] = make("field_at", {{"shape", from(field)}, {"point", from("places.points")}});
  }
  CatalogueGraph graph = graph_of(nodes);
  const std::vector<double> shape = graph.all<double>("at_shape_first.value");
  const std::vector<double> field = graph.all<double>("at_field_first.value");
  for (std::size_t i = 0; i < shape.size(); ++i) {
    CHECK((shape[i] < 0) == (field[i] < 0));
    if (shape[i] > 0) CHECK(field[i] == Approx(shape[i]).margin(1e-9));
  }
}

TEST_CASE("Unions, intersections and differences hold what their words say") {
  Json nodes = ball_and_ring();
  for (const char* word : {"union", "intersection", "difference"}) {
    nodes[word] = make("combine_fields", {{"fields", {from("a"), from("b")}}, {"operation", word}});
    nodes[std::string(word) + "_mesh"] = make("implicit", {{"field", from(word)}, {"resolution", 96}});
  }
  nodes["a_mesh"] = make("implicit", {{"field", from("a")}, {"resolution", 96}});
  nodes["b_mesh"] = make("implicit", {{"field", from("b")}, {"resolution", 96}});
  CatalogueGraph graph = graph_of(nodes);
  std::map<std::string, double> volume;
  for (const char* name : {"a", "b", "union", "intersection", "difference"}) {
    const Measures measures = measure(*graph.one<SharedMesh>(std::string(name) + "_mesh"), never_stopped);
    CAPTURE(name);
    CHECK(measures.closed);
    volume[name] = measures.volume;
  }
  CHECK(volume["a"] == Approx(4.0 / 3 * 3.14159265 * 0.512).epsilon(3e-3));
  CHECK(volume["b"] == Approx(2 * 3.14159265 * 3.14159265 * 0.9 * 0.0625).epsilon(6e-3));
  CHECK(volume["union"] + volume["intersection"] == Approx(volume["a"] + volume["b"]).epsilon(2e-3));
  CHECK(volume["difference"] + volume["intersection"] == Approx(volume["a"]).epsilon(3e-3));
}

TEST_CASE("A family of fields is combined along its axis, and made into a family of meshes without") {
  Json nodes = {{"radius", make("list", {{"items", {0.3, 0.5, 0.7}}, {"axis", "size"}})},
                {"ball", make("sphere", {{"radius", from("radius")}})},
                {"solid", make("solid", {{"shape", from("ball")}})},
                {"all", make("combine_fields", {{"fields", from("solid")}})},
                {"one", make("implicit", {{"field", from("all")}, {"resolution", 24}})},
                {"three", make("implicit", {{"field", from("solid")}, {"resolution", 24}})}};
  CatalogueGraph graph = graph_of(nodes);
  const std::vector<SharedMesh> three = graph.all<SharedMesh>("three");
  REQUIRE(three.size() == 3);
  CHECK(*three[2]->positions == *graph.one<SharedMesh>("one")->positions);
}

TEST_CASE("An offset of a boosted solid is as far away as it says") {
  Json nodes = ball_and_ring();
  nodes["moved"] = make("boost", {{"shape", from("b")}, {"generator", from("tau")}, {"amount", 0.4}});
  nodes["grown"] = make("offset_field", {{"shape", from("moved")}, {"distance", 0.04}});
  nodes["thin"] = make("implicit", {{"field", from("moved")}, {"resolution", 48}});
  nodes["thick"] = make("implicit", {{"field", from("grown")}, {"resolution", 48}});
  CatalogueGraph graph = graph_of(nodes);
  const SharedMesh thin = graph.one<SharedMesh>("thin"), thick = graph.one<SharedMesh>("thick");
  CHECK(graph.warnings().empty());
  for (std::size_t i = 0; i < thick->positions.size(); i += 7) {
    double nearest = 1;
    for (std::size_t k = 0; k < thin->positions.size(); ++k) {
      nearest = std::min(nearest, length(to_vector(thick->positions[i]) - to_vector(thin->positions[k])));
    }
    CHECK(nearest > 0.038);
    CHECK(nearest < 0.08);  // half a cell beside the nearest vertex
  }
}

TEST_CASE("A draft of an implicit surface has at most the triangles that it was given") {
  Json nodes = ball_and_ring();
  nodes["mesh"] = make("implicit", {{"field", from("b")}, {"resolution", 200}});
  nodes["out"] = make("export", {{"model", from("mesh")}});
  CatalogueGraph graph = graph_of(nodes, Quality::draft);
  const SharedMesh mesh = graph.one<SharedMesh>("mesh");
  CHECK(mesh->triangles.size() > 1000);
  CHECK(mesh->triangles.size() <= Detail::usual_triangle_budget);
  CHECK(measure(*mesh, never_stopped).closed);
}

TEST_CASE("Fields that are too large or too deep are refused, and warps that no field can take") {
  Json nodes = ball_and_ring();
  nodes["n0"] = make("shell_field", {{"shape", from("a")}});
  for (int k = 1; k < 140; ++k) {
    nodes["n" + std::to_string(k)] = make("shell_field", {{"shape", from("n" + std::to_string(k - 1))}});
  }
  CHECK(graph_of(nodes).problems("n139").front().code == "limit-exceeded");

  Json doubled = ball_and_ring();
  doubled["n0"] = make("combine_fields", {{"fields", {from("a"), from("b")}}});
  for (int k = 1; k < 30; ++k) {
    const std::string before = "n" + std::to_string(k - 1);
    doubled["n" + std::to_string(k)] = make("combine_fields", {{"fields", {from(before), from(before)}}});
  }
  CHECK(graph_of(doubled).problems("n29").front().code == "limit-exceeded");

  Json warped = ball_and_ring();
  warped["warped"] =
      make("warp", {{"shape", from("a")}, {"generators", {from("tau")}}, {"method", "sum_displacements"}});
  CHECK(graph_of(warped).problems("warped").front().port == "method");
}

TEST_CASE("A solid beyond its box is closed there with a warning, and an empty box is told") {
  Json nodes = ball_and_ring();
  nodes["cut"] = make("implicit", {{"field", from("a")}, {"size", {1, 1, 1}}, {"resolution", 16}});
  nodes["none"] = make("implicit", {{"field", from("a")}, {"center", {5, 0, 0}}, {"resolution", 16}});
  CatalogueGraph graph = graph_of(nodes);
  CHECK(measure(*graph.one<SharedMesh>("cut"), never_stopped).closed);
  CHECK(graph.warnings().front().code == "capped");
  CHECK(graph.one<SharedMesh>("none")->triangles.empty());
  CHECK(graph.warnings().front().code == "empty");
}

TEST_CASE("The lamp shade and the invagination are watertight for random settings within their bounds") {
  for (const char* id : {"lamp_shade", "invagination"}) {
    const Json document = read_example(id);
    RandomElements random(21);
    for (int round = 0; round < 3; ++round) {
      Json numbers;
      for (const auto& [name, parameter] : document["parameters"].items()) {
        const double low = parameter["min"], high = parameter["max"];
        numbers[name] = low + (high - low) * (0.5 + random.number(0.5));
      }
      Json nodes = with_numbers(document["nodes"], numbers);
      nodes["mesh"]["inputs"]["resolution"] = 64;
      CAPTURE(id, numbers.dump());
      CatalogueGraph graph = graph_of(nodes);
      const Measures measures = measure(*graph.one<SharedMesh>("mesh"), never_stopped);
      CHECK(measures.closed);
      CHECK(measures.volume > 0);
      CHECK(measures.euler % 2 == 0);
      CHECK(graph.warnings().empty());
    }
  }
}

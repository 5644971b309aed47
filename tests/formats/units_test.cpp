// Documents that say what their coordinates count, and the files written by it.

#include <catch2/catch.hpp>
#include <cmath>
#include <regex>

#include "geometry/json.h"
#include "geometry/length_unit.h"
#include "geometry/stl_reader.h"
#include "gltf/glb_container.h"
#include "gltf/glb_import.h"
#include "tests/formats/three_mf_reader.h"
#include "tests/support/folder.h"
#include "tests/support/requests.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A box whose far corner is at (30, 20, 10), and a circle around the origin of radius 5.
Json graph(const Json& unit) {
  Json json = document({{"box", make("box_mesh", {{"center", {15, 10, 5}}, {"size", {30, 20, 10}}, {"segments", 1}})},
                        {"ring", make("circle", {{"radius", 5}})},
                        {"out", make("export", {{"model", {from("box"), from("ring")}}, {"position_bits", 20}})}});
  if (!unit.is_null()) json["meta"] = {{"title", "A box"}, {"unit", unit}};
  return json;
}

std::string written(const Json& unit, const std::string& format) {
  const std::unique_ptr<Engine> engine = make_engine();
  return file_of(*engine, {.graph = graph(unit), .format = format, .draco = false});
}

double far_x(const ImportedMesh& read) {
  double most = 0;
  for (std::size_t i = 0; i < read.mesh.positions.size(); ++i) most = std::max(most, read.mesh.positions[i].x);
  return most;
}

}  // namespace

TEST_CASE("Words for units are exact lengths") {
  CHECK(millimeters_of(*length_unit_named("m")) == 1000);
  CHECK(millimeters_of(*length_unit_named("cm")) == 10);
  CHECK(millimeters_of(*length_unit_named("mm")) == 1);
  CHECK(millimeters_of(*length_unit_named("in")) == 25.4);
  CHECK_FALSE(length_unit_named("ft"));
  for (const std::string_view word : length_unit_names) CHECK(name(*length_unit_named(word)) == word);
}

TEST_CASE("An STL is in millimeters where the document says a unit, and in meters as ever where not") {
  const std::vector<std::pair<Json, double>> units = {
      {nullptr, 30}, {"m", 30000}, {"cm", 300}, {"mm", 30}, {"in", 762}};
  for (const auto& [unit, expected] : units) {
    CAPTURE(unit.dump());
    const std::string file = written(unit, "stl");
    CHECK((file.find("unit: millimeter") != std::string::npos) == !unit.is_null());
    const ImportResult read = read_stl(file, {}, Cancel());
    REQUIRE(read);
    CHECK(far_x(*read) == Approx(expected).epsilon(1e-6));
  }
}

TEST_CASE("A 3MF says its unit, and has coordinates in it") {
  for (const auto& [unit, expected] : std::vector<std::pair<Json, double>>{{nullptr, 30}, {"cm", 300}, {"in", 762}}) {
    CAPTURE(unit.dump());
    const Folder folder("units");
    folder.write("box.3mf", written(unit, "3mf"));
    const ThreeMfFile file = read_three_mf((folder.path() / "box.3mf").string());
    CHECK(file.warnings.empty());
    CHECK(file.in_meters == unit.is_null());
    CHECK(file.in_millimeters == !unit.is_null());
    REQUIRE(file.objects.size() == 1);
    float most = 0;
    for (const auto& vertex : file.objects[0].vertices) most = std::max(most, vertex[0]);
    CHECK(most == Approx(expected).epsilon(1e-6));
  }
}

TEST_CASE("A glTF is in meters whatever the document counts, by its root") {
  for (const auto& [unit, expected] :
       std::vector<std::pair<Json, double>>{{nullptr, 30}, {"m", 30}, {"mm", 0.03}, {"in", 0.762}}) {
    CAPTURE(unit.dump());
    const std::string file = written(unit, "glb");
    const Json gltf = Json::parse(split_glb(file)->json);
    CHECK(gltf["nodes"][0].contains("scale") == (unit == "mm" || unit == "in"));
    CHECK(gltf["asset"]["extras"].contains("unit") == !unit.is_null());
    const ImportResult read = read_glb_mesh(file, {}, Cancel());
    REQUIRE(read);
    CHECK(far_x(*read) == Approx(expected).epsilon(1e-5));
  }
}

TEST_CASE("An OBJ stays in meters, as it says") {
  const std::string file = written("mm", "obj");
  CHECK(file.find("# unit: meter") != std::string::npos);
  CHECK(file.find("v 0.03 0.02 0.01") != std::string::npos);
}

TEST_CASE("An SVG is a drawing in millimeters with y up") {
  for (const auto& [unit, radius] : std::vector<std::pair<Json, double>>{{nullptr, 5000}, {"mm", 5}, {"in", 127}}) {
    CAPTURE(unit.dump());
    const std::string file = written(unit, "svg");
    CHECK(file.starts_with("<?xml"));
    std::smatch size;
    REQUIRE(std::regex_search(file, size, std::regex(" width=\"([0-9.]+)mm\" height=\"([0-9.]+)mm\"")));
    CHECK(std::stod(size[1]) == Approx(2 * radius).epsilon(0.01));
    CHECK(std::stod(size[2]) == Approx(2 * radius).epsilon(0.01));
    CHECK(file.find("<g id=\"ring\"") != std::string::npos);
    CHECK(file.find("id=\"box\"") == std::string::npos);
    const std::regex place("[ML]([-0-9.e+]+) ([-0-9.e+]+)");
    std::size_t places = 0;
    for (auto found = std::sregex_iterator(file.begin(), file.end(), place); found != std::sregex_iterator(); ++found) {
      CHECK(std::hypot(std::stod((*found)[1]), std::stod((*found)[2])) == Approx(radius).epsilon(1e-5));
      ++places;
    }
    CHECK(places == 256);
    CHECK(file.find("Z\"/>") != std::string::npos);
  }
}

TEST_CASE("A unit is part of what a graph is, another note is not") {
  const std::unique_ptr<Engine> engine = make_engine();
  const auto hash_of = [&](const Json& unit) { return engine->read(graph(unit))->hash; };
  CHECK(hash_of("mm") != hash_of("cm"));
  CHECK(hash_of("mm") != hash_of(nullptr));
  Json renamed = graph("mm"), untitled = graph(nullptr);
  renamed["meta"]["title"] = "Another";
  CHECK(engine->read(renamed)->hash == hash_of("mm"));
  untitled["meta"] = {{"title", "Another"}};
  CHECK(engine->read(untitled)->hash == hash_of(nullptr));
}

TEST_CASE("A file carries the unit of its document, and is written again from it") {
  const std::unique_ptr<Engine> engine = make_engine();
  const auto gltf_of = [&](const Json& asked) {
    return Json::parse(split_glb(file_of(*engine, {.graph = asked, .embed_graph = true}))->json);
  };
  const Json once = gltf_of(graph("mm"));
  const Json carried = once["asset"]["extras"]["document"];
  CHECK(carried["meta"]["unit"] == "mm");
  CHECK(gltf_of(carried) == once);
}

TEST_CASE("A unit that is none is refused, and says which there are") {
  const std::unique_ptr<Engine> engine = make_engine();
  for (const Json& unit : {Json("ft"), Json(3), Json(nullptr)}) {
    Json wrong = graph("mm");
    wrong["meta"]["unit"] = unit;
    const auto answer = prepared_for(*engine, {.graph = wrong});
    REQUIRE_FALSE(answer);
    CHECK(answer.problems().front().code == "not-in-choices");
    CHECK(answer.problems().front().pointer == "/meta/unit");
    CHECK(answer.problems().front().detail.find("\"mm\"") != std::string::npos);
  }
}

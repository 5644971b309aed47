// What formats say about what they cannot hold, and what none of them writes.

#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/box.h"
#include "nodes/formats.h"

using namespace dini;

namespace {

Mesh box() { return box_mesh({0, 0, 0}, {1, 1, 1}, 1, Cancel()); }

Part part_of(const std::string& name, Mesh mesh) { return {name, std::make_shared<const Mesh>(std::move(mesh)), {}}; }

Part ring() {
  Polyline line{Column<Point>(3), true};
  line.points.set(1, {1, 0, 0});
  line.points.set(2, {0, 1, 0});
  return {"ring", std::vector<Polyline>{line}};
}

Part dot() { return {"dot", std::make_shared<const Column<Point>>(1)}; }

Scene everything() {
  Mesh red = box(), shiny = box();
  red.color = {1, 0, 0, 0.5};
  shiny.finish.metallic = 1;
  Scene scene;
  for (int i = 0; i < 5; ++i) scene.parts.push_back(part_of("red[" + std::to_string(i) + "]", red));
  scene.parts.push_back(part_of("shiny", shiny));
  scene.parts.push_back(ring());
  scene.parts.push_back(dot());
  scene.parts.push_back(part_of("nothing", Mesh{}));
  return scene;
}

FileOptions with_graph() {
  FileOptions options;
  options.about = {{"engine", "1.2.3"}, {"document", {{"format", 1}}}};
  return options;
}

std::vector<std::string> file_notes(const std::string& name) {
  const auto file = format_named(all_formats(), name)->write(everything(), with_graph(), Cancel());
  if (!file) return {file.error().detail};
  std::vector<std::string> notes;
  for (const FileNote& note : file->notes) notes.push_back(note.code + ": " + note.detail);
  return notes;
}

}  // namespace

TEST_CASE("What a format cannot hold is told once for each kind, with the names of the parts") {
  const std::string reds = "red[0], red[1], red[2] and 2 more";
  const std::string empty = "empty: nothing has nothing to draw";
  const std::string finish = " holds neither metallic nor roughness nor sides; without theirs in the file: shiny";
  CHECK(file_notes("glb") == std::vector<std::string>{empty});
  CHECK(file_notes("obj") == std::vector<std::string>{empty,
                                                      "left-out: OBJ holds no opacity; opaque in the file: " + reds,
                                                      "left-out: OBJ" + finish});
  CHECK(file_notes("stl") ==
        std::vector<std::string>{empty, "left-out: STL holds no curves; not in the file: ring",
                                 "left-out: STL holds no points; not in the file: dot",
                                 "left-out: STL holds no colors; without theirs in the file: " + reds,
                                 "left-out: STL holds no opacity; opaque in the file: " + reds,
                                 "left-out: STL" + finish,
                                 "left-out: STL has no room for the graph; it is not in the file"});
  CHECK(file_notes("ply") ==
        std::vector<std::string>{empty, "left-out: PLY holds no curves; not in the file: ring",
                                 "left-out: PLY" + finish,
                                 "left-out: PLY has no room for the graph; it is not in the file"});
  CHECK(file_notes("3mf") == std::vector<std::string>{empty, "left-out: 3MF holds no curves; not in the file: ring",
                                                      "left-out: 3MF holds no points; not in the file: dot",
                                                      "left-out: 3MF" + finish});
  CHECK(file_notes("svg") ==
        std::vector<std::string>{"left-out: SVG holds no meshes; not in the file: red[0], red[1], red[2] and 4 more",
                                 "left-out: SVG holds no points; not in the file: dot",
                                 "left-out: SVG has no room for the graph; it is not in the file"});
}

TEST_CASE("Meshes alone are nothing to export for a format of curves, which says so") {
  Scene scene;
  scene.parts.push_back(part_of("box", box()));
  const auto file = format_named(all_formats(), "svg")->write(scene, {}, Cancel());
  REQUIRE_FALSE(file);
  CHECK(file.error().code == "nothing-to-export");
  CHECK(file.error().detail.find("give the export curves or circles") != std::string::npos);
}

TEST_CASE("No format writes a number that is none, and each names the part") {
  for (const double wrong : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (const FileFormat& format : all_formats()) {
      if (format.name == "svg") continue;  // it holds no meshes
      CAPTURE(format.name, wrong);
      Mesh torn = box();
      torn.positions.set(torn.triangles[3][1], {0, wrong, 0});
      Scene scene;
      scene.parts.push_back(part_of("fine", box()));
      scene.parts.push_back(part_of("torn", std::move(torn)));
      const auto file = format.write(scene, {}, Cancel());
      REQUIRE_FALSE(file);
      CHECK(file.error().code == "non-finite");
      CHECK(file.error().detail.starts_with("torn: "));
    }
  }
}

TEST_CASE("Curves alone are nothing to export for a format of meshes, which says so") {
  Scene scene;
  scene.parts.push_back(ring());
  for (const FileFormat& format : all_formats()) {
    CAPTURE(format.name);
    const auto file = format.write(scene, {}, Cancel());
    if (format.name == "glb" || format.name == "gltf" || format.name == "obj" || format.name == "svg") {
      CHECK(file);
      continue;
    }
    REQUIRE_FALSE(file);
    CHECK(file.error().code == "nothing-to-export");
    CHECK(file.error().detail.find("give the export a mesh") != std::string::npos);
  }
}

TEST_CASE("Every format that has a place for it says that it is in meters with z up, and by whom it is") {
  const auto bytes = [](const char* name) {
    return format_named(all_formats(), name)->write(everything(), with_graph(), Cancel())->bytes;
  };
  CHECK(bytes("obj").starts_with("# Dini 1.2.3\n# unit: meter, z up\n# {\"document\":{\"format\":1},"));
  CHECK(bytes("stl").starts_with("Dini 1.2.3, unit: meter, z up  "));
  CHECK(bytes("stl").size() == 84 + 50 * 12 * 6);
  CHECK(bytes("ply").find("\ncomment Dini 1.2.3\ncomment unit: meter, z up\n") != std::string::npos);
}

TEST_CASE("A scene gives the same bytes again in every format") {
  for (const FileFormat& format : all_formats()) {
    CAPTURE(format.name);
    const auto once = format.write(everything(), with_graph(), Cancel());
    const auto again = format.write(everything(), with_graph(), Cancel());
    REQUIRE(once);
    CHECK(once->bytes == again->bytes);
  }
}

TEST_CASE("Writing stops when it is told to") {
  Cancel told;
  told.stop(StopReason::superseded);
  for (const FileFormat& format : all_formats()) {
    CAPTURE(format.name);
    CHECK_FALSE(format.write(everything(), {}, told));
  }
}

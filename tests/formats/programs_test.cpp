// Files of every format as other programs read them: Assimp, OpenCTM, and for 3MF the library of its makers.

#include <catch2/catch.hpp>

#include "geometry/file_colors.h"
#include "geometry/obj_reader.h"
#include "geometry/ply_reader.h"
#include "geometry/stl_reader.h"
#include "gltf/glb_import.h"
#include "nodes/formats.h"
#include "tests/cli/program.h"
#include "tests/formats/three_mf_reader.h"
#include "tests/support/catalogue.h"
#include "tests/support/close.h"
#include "tests/support/documents.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A torus with colors at its vertices, a box of flat faces in one color, and a ring, each under its name.
Json nodes() {
  return {{"torus", make("torus_mesh", {{"center", {0, 0, 2}}, {"segments", 24}, {"sides", 12}})},
          {"shell", make("curvature_color", {{"shape", from("torus")}})},
          {"block", make("box_mesh", {{"center", {4, 0, 0}}, {"size", {1, 2, 3}}, {"segments", 2}})},
          {"box", make("material", {{"shape", from("block")}, {"color", {1, 0.5, 0}}, {"opacity", 0.5}})},
          {"ring", make("circle", {{"radius", 2}})},
          {"out", make("export", {{"model", {from("shell"), from("box"), from("ring")}}, {"draco", false}})}};
}

/// The file of the graph, or of one node of it, in a format, written by the program.
std::filesystem::path written(const Folder& folder, const FileFormat& format, const std::string& part = "") {
  Json asked = nodes();
  if (!part.empty()) asked["out"]["inputs"]["model"] = from(part);
  folder.write("graph.json", document(asked).dump());
  const std::filesystem::path path = folder.path() / ("model" + format.extension);
  const Outcome outcome =
      Program({DINI_WITH_COUNTS, "eval", (folder.path() / "graph.json").string(), "-o", path.string()}).wait();
  CAPTURE(outcome.err);
  REQUIRE(outcome.code == 0);
  return path;
}

/// What a program takes a file for when it is told to write it as `seen.ply`.
Mesh seen_by(const Folder& folder, const std::vector<std::string>& words) {
  const Outcome outcome = Program(words).wait();
  CAPTURE(words, outcome.out, outcome.err);
  REQUIRE(outcome.code == 0);
  const ImportResult read = read_ply(folder.read("seen.ply"), {});
  if (!read) FAIL(read.error().detail);
  return read->mesh;
}

/// What Assimp takes a file for, with the places of all its nodes. All parts have to have the same attributes.
Mesh seen_by_assimp(const Folder& folder, const std::filesystem::path& path) {
  return seen_by(folder, {DINI_ASSIMP, "export", path.string(), (folder.path() / "seen.ply").string()});
}

/// A mesh of the graph with colors at its vertices, or all of them in one.
Mesh original(const std::string& part = "all") {
  Json asked = nodes();
  asked.erase("out");
  asked["all"] = make("merge", {{"meshes", {from("shell"), from("box")}}});
  CatalogueGraph graph = graph_of(asked);
  Mesh mesh = *graph.one<SharedMesh>(part);
  std::array<float, 4> color{};
  std::copy(mesh.color.begin(), mesh.color.end(), color.begin());
  mesh.colors.resize(mesh.positions.size(), color);
  return mesh;
}

void turn_upright(Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Point p = mesh.positions[i];
    mesh.positions.set(i, {p.x, -p.z, p.y});
    const Vector n = mesh.normals[i];
    mesh.normals.set(i, {n.x, -n.z, n.y});
  }
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector at = to_vector(mesh.positions[a]);
    sum += length(cross(to_vector(mesh.positions[b]) - at, to_vector(mesh.positions[c]) - at)) / 2;
  }
  return sum;
}

/// The largest distance from a vertex of one mesh to the nearest of another for which `alike` holds as well.
template <class Alike>
double distance_to(const Mesh& from, const Mesh& to, const Alike& alike) {
  double largest = 0;
  for (std::size_t i = 0; i < from.positions.size(); ++i) {
    double nearest = INFINITY;
    for (std::size_t k = 0; k < to.positions.size(); ++k) {
      if (alike(i, k)) nearest = std::min(nearest, distance(from.positions[i], to.positions[k]));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

/// What a format has besides places.
struct Attributes {
  bool normals = false, uvs = false, colors = false;
};

/// Whether vertices look alike: to half a degree, a millionth of a picture, and a step and a half of 255.
auto alike_in(const Attributes& attributes, const Mesh& a, const Mesh& b) {
  return [attributes, &a, &b](std::size_t i, std::size_t k) {
    if (attributes.normals && length(a.normals[i] - b.normals[k]) > 0.01) return false;
    if (attributes.uvs && std::abs(a.uvs[i][0] - b.uvs[k][0]) + std::abs(a.uvs[i][1] - b.uvs[k][1]) > 1e-6)
      return false;
    if (!attributes.colors) return true;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double here = picture_share(static_cast<double>(a.colors[i][channel]));
      const double there = picture_share(static_cast<double>(b.colors[k][channel]));
      if (std::abs(here - there) > 1.5 / 255) return false;
    }
    return true;
  };
}

const FileFormat& format_called(const std::string& name) {
  const FileFormat* const format = format_named(all_formats(), name);
  REQUIRE(format != nullptr);
  return *format;
}

// Coordinates are floats below 8, and Assimp turns those of a GLB in floats once more.
constexpr double deviation = 2e-6;

}  // namespace

TEST_CASE("Assimp finds every vertex of every format at its place, with the attributes that the format has") {
  const std::string part = GENERATE("shell", "box");
  const Mesh expected = original(part);
  for (const auto& [name, attributes] : std::map<std::string, Attributes>{{"glb", {true, true, false}},
                                                                          {"obj", {true, true, true}},
                                                                          {"stl", {}},
                                                                          {"ply", {true, true, true}},
                                                                          {"3mf", {}}}) {
    CAPTURE(name, part);
    const Folder folder;
    Mesh seen = seen_by_assimp(folder, written(folder, format_called(name), part));
    if (name == "glb") turn_upright(seen);
    CHECK(seen.triangles.size() == expected.triangles.size());
    CHECK(area(seen) == Approx(area(expected)).epsilon(1e-6));
    CHECK(distance_to(expected, seen, alike_in(attributes, expected, seen)) < deviation);
    CHECK(distance_to(seen, expected, alike_in(attributes, seen, expected)) < deviation);
  }
}

TEST_CASE("OpenCTM finds every vertex of the formats that it reads at its place") {
  const std::string part = GENERATE("shell", "box");
  const Mesh expected = original(part);
  // It reads neither the colors of an OBJ nor any glTF or 3MF.
  for (const auto& [name, attributes] :
       std::map<std::string, Attributes>{{"obj", {true, true, false}}, {"stl", {}}, {"ply", {true, true, true}}}) {
    const Folder folder;
    const std::string path = written(folder, format_called(name), part).string();
    const Mesh seen = seen_by(folder, {DINI_CTMCONV, path, (folder.path() / "seen.ply").string()});
    const double lost = distance_to(expected, seen, alike_in(attributes, expected, seen));
    const double gained = distance_to(seen, expected, alike_in(attributes, seen, expected));
    CAPTURE(name, part, lost, gained);
    CHECK(seen.triangles.size() == expected.triangles.size());
    CHECK(area(seen) == Approx(area(expected)).epsilon(1e-6));
    CHECK(lost < deviation);
    CHECK(gained < deviation);
  }
}

TEST_CASE("Assimp finds parts by the names of their nodes") {
  for (const std::string name : {"glb", "obj"}) {
    CAPTURE(name);
    const Folder folder;
    const Outcome outcome = Program({DINI_ASSIMP, "info", written(folder, format_called(name)).string()}).wait();
    for (const char* const part : {"(shell)", "(box)", "(ring)"}) CHECK(outcome.out.find(part) != std::string::npos);
  }
}

TEST_CASE("The library of the makers of 3MF finds closed objects in meters with their names and colors") {
  const Folder folder;
  const ThreeMfFile file = read_three_mf(written(folder, format_called("3mf")).string());
  CHECK(file.in_meters);
  CHECK(file.warnings.empty());
  REQUIRE(file.objects.size() == 2);
  for (const ThreeMfObject& object : file.objects) {
    CHECK(object.is_model);
    CHECK(object.is_manifold);
  }
  const ThreeMfObject& shell = file.objects[0];
  const ThreeMfObject& box = file.objects[1];
  CHECK(shell.name == "shell");
  CHECK(shell.vertices.size() == 24 * 12);
  CHECK(box.name == "box");
  CHECK(box.vertices.size() == 26);
  CHECK(box.triangles.size() == 48);
  CHECK(box.material == "box #FFBC0080");
  REQUIRE(shell.colors.size() == shell.triangles.size());
  // Every corner has the color of a vertex at its place.
  const Mesh expected = original();
  for (std::size_t i = 0; i < shell.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& [x, y, z] = shell.vertices[shell.triangles[i][k]];
      bool found = false;
      for (std::size_t v = 0; v < expected.positions.size() && !found; ++v) {
        if (distance(expected.positions[v], Point{x, y, z}) > deviation) continue;
        found = true;
        for (std::size_t channel = 0; channel < 3 && found; ++channel) {
          const double share = 255 * picture_share(static_cast<double>(expected.colors[v][channel]));
          found = std::abs(share - shell.colors[i][k][channel]) < 1.5;
        }
      }
      CHECK(found);
    }
  }
}

TEST_CASE("An open mesh is a surface in a 3MF") {
  const Folder folder;
  folder.write("open.json", document({{"grid", make("grid")},
                                      {"sheet", make("surface", {{"shape", from("grid.points")}})},
                                      {"out", make("export", {{"model", from("sheet")}})}})
                                .dump());
  const std::string path = (folder.path() / "open.3mf").string();
  REQUIRE(Program({DINI_WITH_COUNTS, "eval", (folder.path() / "open.json").string(), "-o", path}).wait().code == 0);
  const ThreeMfFile file = read_three_mf(path);
  REQUIRE(file.objects.size() == 1);
  CHECK_FALSE(file.objects[0].is_model);
  CHECK(file.objects[0].material == "sheet #E1E5EAFF");
}

TEST_CASE("What was written is read again at the same place by the readers of imports") {
  const Mesh expected = original();
  const Folder folder;
  const auto check = [&](const std::string& name, auto read, const Attributes& attributes) {
    CAPTURE(name);
    written(folder, format_called(name));
    const ImportResult result = read(folder.read("model." + name), ImportLimits(), Cancel());
    if (!result) FAIL(result.error().detail);
    Mesh mesh = result->mesh;
    if (name == "glb") turn_upright(mesh);
    CHECK(mesh.triangles.size() == expected.triangles.size());
    CHECK(distance_to(expected, mesh, alike_in(attributes, expected, mesh)) < deviation);
    CHECK(distance_to(mesh, expected, alike_in(attributes, mesh, expected)) < deviation);
  };
  check("glb", read_glb_mesh, {true, true, true});
  check("obj", read_obj, {true, true, true});
  check("ply", read_ply, {true, true, true});
  check("stl", read_stl, {});
}

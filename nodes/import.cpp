// Meshes from files. The file has been read before a graph is planned: see graph/asset_file.h.

#include <algorithm>
#include <cmath>

#include "geometry/decimate.h"
#include "geometry/validate.h"
#include "graph/node_builder.h"
#include "nodes/all.h"

namespace dini {

enum class UpAxis { format, z, y };

template <>
struct ChoiceNames<UpAxis> {
  static constexpr std::array<std::string_view, 3> names = {"format", "z", "y"};
};

namespace {

/// The middle of the box around all vertices.
Vector middle_of(const Mesh& mesh) {
  std::array<double, 3> middle = {0, 0, 0};
  const std::size_t count = mesh.positions.size();
  for (std::size_t k = 0; k < 3 && count > 0; ++k) {
    const double* values = mesh.positions.component(k);
    const auto [least, most] = std::minmax_element(values, values + count);
    middle[k] = *least / 2 + *most / 2;
  }
  return {middle[0], middle[1], middle[2]};
}

Vector turned_upright(const Vector& v, bool y_up) { return y_up ? Vector{v.x, -v.z, v.y} : v; }

struct ImportInputs {
  UpAxis up;
  double scale;
  bool center;
};

Attempt<SharedMesh> imported(const Context& context, const SharedAssetFile& asset, const ImportInputs& in) {
  const Mesh& whole = asset->content.mesh;
  for (const std::string& warning : asset->content.warnings) context.warn({"left-out", warning, "asset"});
  const bool thin = context.triangle_budget() > 0 && whole.triangles.size() > context.triangle_budget();
  const Mesh coarse = thin ? decimate(whole, context.triangle_budget(), context.cancel()) : Mesh{};
  const Mesh& mesh = thin ? coarse : whole;
  const bool y_up = in.up == UpAxis::y || (in.up == UpAxis::format && asset->content.format == MeshFormat::glb);
  // The same memory: most graphs take the file as it is.
  if (!thin && !y_up && in.scale == 1 && !in.center) return SharedMesh(asset, &mesh);
  Column<Point> positions(mesh.positions.size());
  Column<Vector> normals(mesh.normals.size());
  const Vector middle = in.center ? middle_of(whole) : Vector{};
  CancelEvery steps(context.cancel());
  for (std::size_t i = 0; i < mesh.positions.size() && !steps.stopped(); ++i) {
    const Vector place = in.scale * turned_upright(to_vector(mesh.positions[i]) - middle, y_up);
    if (!is_within_reach(to_point(place))) {
      return Failure{"out-of-range", "scaled like this, the mesh has coordinates of 1e18 and more", "scale"};
    }
    positions.set(i, to_point(place));
  }
  for (std::size_t i = 0; i < mesh.normals.size() && !steps.stopped(); ++i) {
    normals.set(i, turned_upright(mesh.normals[i], y_up));
  }
  auto copy = std::make_shared<Mesh>(mesh);
  copy->positions = std::move(positions);
  copy->normals = std::move(normals);
  return SharedMesh(std::move(copy));
}

/// Never less than half the triangles, from which the size of everything made of the mesh is predicted.
std::size_t vertices_of(const Literals& literals, const Axes&) {
  const Mesh& mesh = file_at(literals, "asset").content.mesh;
  return std::max(mesh.positions.size(), (mesh.triangles.size() + 1) / 2);
}

/// Also four times of this is never less than what subdividing makes where no two triangles share an edge: a vertex for
/// each of three edges of a triangle.
std::size_t most_vertices_of(const Literals& literals, const Axes& consumed) {
  const Mesh& mesh = file_at(literals, "asset").content.mesh;
  return std::max(vertices_of(literals, consumed), (mesh.positions.size() + 3 * mesh.triangles.size() + 3) / 4);
}

}  // namespace

void add_import(Registry& registry) {
  registry.add(
      node("import", imported)
          .title("Import")
          .family("meshes")
          .synonyms({"file", "load", "open", "obj", "stl", "ply", "glb", "read"})
          .doc("A mesh from an OBJ, PLY, STL or GLB file that was uploaded, or given on the command line.")
          .version(2)
          .details("Texture coordinates, vertex colors and normals are kept; missing normals are computed. "
                   "Materials, textures and animations are left out, and skins are taken in the pose of the file. "
                   "Polygons become triangles. What of the file is left out is a warning. A file that is not "
                   "known here is an error.")
          .input("asset", "The sha256 of an uploaded file, or the name given to a file by --asset.",
                 required().title("File"))
          .input("up", &ImportInputs::up, "Which axis of the file is up; by its format: y in GLB, z in the others.",
                 defaults("format").title("Up axis"))
          .input("scale", &ImportInputs::scale, "Factor from the file's unit to meters.",
                 defaults(1).hard(1e-9, 1e9).soft(0.1, 10).title("Meters per unit"))
          .input("center", &ImportInputs::center, "Whether the middle of the mesh moves to the origin.",
                 defaults(false).title("To the origin"))
          .vertices(vertices_of, most_vertices_of)
          .thinned_to(12)
          .cost([](const RunSize& size) {
            return RunCost{100 * size.vertices, 64 * size.vertices};
          })
          .output("mesh", "The mesh."));
}

}  // namespace dini

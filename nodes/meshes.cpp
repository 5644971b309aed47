#include "geometry/merge.h"
#include "geometry/primitives.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/costs.h"
#include "nodes/draft.h"

namespace dini {

namespace {

struct SphereMeshInputs {
  Point center;
  double radius;
  std::int64_t segments, rings;
};

SharedMesh sphere(const Context& context, const SphereMeshInputs& in) {
  const Segments used = within_budget(context, in.segments, in.rings, {3, 2});
  return std::make_shared<const Mesh>(sphere_mesh(in.center, in.radius, used.along, used.across, context.cancel()));
}

struct TorusMeshInputs {
  Point center;
  Vector axis;
  double major_radius, minor_radius;
  std::int64_t segments, sides;
};

Attempt<SharedMesh> torus(const Context& context, const TorusMeshInputs& in) {
  if (in.axis == Vector{}) return Failure{"degenerate", "the axis of a torus must not be zero", "axis"};
  const Segments used = within_budget(context, in.segments, in.sides, {3, 3});
  return std::make_shared<const Mesh>(
      torus_mesh(in.center, in.axis, in.major_radius, in.minor_radius, used.along, used.across, context.cancel()));
}

SharedMesh merged(const Context& context, const Several<WireType::mesh>& meshes) {
  std::vector<SharedMesh> all;
  for (const Value& value : meshes.values) {
    const Column<SharedMesh>& column = column_of<SharedMesh>(value);
    for (std::size_t i = 0; i < column.size(); ++i) all.push_back(column[i]);
  }
  return std::make_shared<const Mesh>(merge(all, context.cancel()));
}

struct ColorInputs {
  Color color;
};

SharedMesh colored(const SharedMesh& shape, const ColorInputs& in) {
  auto copy = std::make_shared<Mesh>(*shape);
  copy->colors.clear();
  copy->color = in.color;
  return copy;
}

struct MaterialInputs {
  Color color;
  double opacity, metallic, roughness;
  bool double_sided;
};

SharedMesh with_material(const SharedMesh& shape, const MaterialInputs& in) {
  auto copy = std::make_shared<Mesh>(*shape);
  copy->colors.clear();
  copy->color = in.color;
  copy->color[3] *= in.opacity;
  copy->finish = {in.metallic, in.roughness, in.double_sided};
  return copy;
}

std::size_t grid_vertices(const Literals& literals, const char* first, const char* second) {
  return static_cast<std::size_t>((integer_at(literals, first) + 1) * (integer_at(literals, second) + 1));
}

}  // namespace

void add_meshes(Registry& registry) {
  registry.add(
      node("sphere_mesh", sphere)
          .title("Sphere mesh")
          .family("meshes")
          .synonyms({"ball", "globe", "uv sphere", "planet"})
          .doc("A sphere as a mesh with clean poles.")
          .degenerate("zero radius", "Refused as out of range.")
          .input("center", &SphereMeshInputs::center, "Its center.", defaults({0, 0, 0}).unit("m").position_handle())
          .input("radius", &SphereMeshInputs::radius, "Its radius.",
                 defaults(1).hard(1e-9, 1e6).soft(0.1, 4).unit("m").radius_handle("center"))
          .input("segments", &SphereMeshInputs::segments, "Around the vertical axis.",
                 defaults(96).hard(3, 8192).soft(8, 256).title("Segments around"))
          .input("rings", &SphereMeshInputs::rings, "From pole to pole.", defaults(48).hard(2, 8192).soft(4, 128))
          .vertices([](const Literals& literals, const Axes&) { return grid_vertices(literals, "segments", "rings"); })
          .thinned_to(6)
          .cost(cost_of_grid_surface)
          .output("mesh", "The mesh."));

  registry.add(
      node("torus_mesh", torus)
          .title("Torus mesh")
          .family("meshes")
          .synonyms({"donut", "doughnut", "ring", "tire"})
          .doc("A torus as a mesh.")

          .degenerate("zero radius", "Refused as out of range.")
          .degenerate("zero direction", "A zero axis is an error.")
          .input("center", &TorusMeshInputs::center, "Its center.", defaults({0, 0, 0}).unit("m").position_handle())
          .input("axis", &TorusMeshInputs::axis, "Direction of its axis, of any length.",
                 defaults({0, 0, 1}).direction_handle("center"))
          .input(
              "major_radius", &TorusMeshInputs::major_radius, "From the center to the middle of the tube.",
              defaults(1).hard(1e-9, 1e6).soft(0.1, 4).unit("m").radius_handle("center", "axis").title("Large radius"))
          .input("minor_radius", &TorusMeshInputs::minor_radius, "Of the tube.",
                 defaults(0.3).hard(1e-9, 1e6).soft(0.05, 1).unit("m").title("Small radius"))
          .input("segments", &TorusMeshInputs::segments, "Around the axis.",
                 defaults(128).hard(3, 8192).soft(8, 256).title("Around the axis"))
          .input("sides", &TorusMeshInputs::sides, "Around the tube.",
                 defaults(48).hard(3, 8192).soft(4, 128).title("Around the tube"))
          .vertices([](const Literals& literals, const Axes&) { return grid_vertices(literals, "segments", "sides"); })
          .thinned_to(18)
          .cost(cost_of_grid_surface)
          .output("mesh", "The mesh."));

  registry.add(node("merge", merged)
                   .title("Merge")
                   .family("meshes")
                   .synonyms({"join", "union", "combine", "group", "weld"})
                   .doc("One mesh from many: all links, and all values of their axes.")
                   .input("meshes", "Meshes, over any axes.", required().several())
                   .cost([](const RunSize& size) {
                     return RunCost{0, 60 * size.vertices};
                   })
                   .output("mesh", "The merged mesh."));

  registry.add(
      node("color", colored)
          .title("Color")
          .family("meshes")
          .synonyms({"paint", "tint", "hue", "rgb"})
          .doc("Gives a mesh one color.")
          .input("shape", "The mesh.")
          .input("color", &ColorInputs::color, "Linear red, green, blue and alpha.", defaults({0.2, 0.5, 0.9, 1.0}))
          .cost(cost_of_shared_mesh)
          .output("shape", "The colored mesh."));

  registry.add(
      node("material", with_material)
          .title("Material")
          .family("meshes")
          .synonyms({"finish", "metal", "glass", "gloss", "shader", "pbr", "transparent"})
          .doc("Gives a mesh one color, and says how its surface takes light.")
          .details(
              "Colors of vertices are left out; a node that colors them may follow, and leaves metallic, roughness "
              "and the sides as they are. A merged mesh has those of its first. Files in glTF hold all of it, "
              "others the color only: the export warns of what is left out.")
          .input("shape", "The mesh.")
          .input("color", &MaterialInputs::color, "Linear red, green, blue and alpha.", defaults({0.2, 0.5, 0.9, 1.0}))
          .input("opacity", &MaterialInputs::opacity,
                 "1 hides what is behind, 0 cannot be seen; a factor of the alpha.", defaults(1).hard(0, 1))
          .input("metallic", &MaterialInputs::metallic, "0 for paint, plastic or wood, 1 for bare metal.",
                 defaults(0).hard(0, 1))
          .input("roughness", &MaterialInputs::roughness, "0 is a mirror, 1 is chalk.", defaults(0.6).hard(0, 1))
          .input("double_sided", &MaterialInputs::double_sided, "Whether the back of the surface is seen too.",
                 defaults(true))
          .cost(cost_of_shared_mesh)
          .output("shape", "The mesh with that material."));
}

}  // namespace dini

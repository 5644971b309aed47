#include <cmath>

#include "geometry/implicit_mesh.h"
#include "graph/node_builder.h"
#include "nodes/all.h"

namespace dini {

namespace {

struct ImplicitInputs {
  Point center;
  Vector size;
  std::int64_t resolution;
};

constexpr double least_size = 1e-6, largest_size = 1e6;
constexpr std::int64_t least_resolution = 4;

/// The area of a surface that just fills its box is about six times a side's; folds and holes have room for more.
constexpr std::size_t vertices_per_cell_of_side = 16;

std::size_t most_vertices(std::size_t resolution) { return vertices_per_cell_of_side * resolution * resolution; }

/// What is left of a field in parts of the box is some times the field, where parts overlap.
constexpr std::size_t least_field_bytes = std::size_t{4} << 20, field_bytes_of_vertex = 32;
std::size_t most_field_bytes(const ScalarField& field, std::size_t resolution) {
  return least_field_bytes + field_bytes_of_vertex * most_vertices(resolution) + 8 * field.size().bytes;
}

bool is_usable(double length) { return length >= least_size && length <= largest_size; }

Attempt<SharedMesh> implicit_surface(const Context& context, const SharedField& field, const ImplicitInputs& in) {
  if (!is_usable(in.size.x) || !is_usable(in.size.y) || !is_usable(in.size.z)) {
    return Failure{"out-of-range", "each side of the box must be 1e-6 to 1e6 m", "size"};
  }
  const Vector center = to_vector(in.center);
  if (!is_finite(in.center) || length(center) > 1e6 * length(in.size)) {
    return Failure{"out-of-range", "the center must be within a million times the size of the origin", "center"};
  }
  const auto asked = static_cast<std::size_t>(in.resolution);
  const std::size_t budget = context.triangle_budget();
  std::size_t resolution = asked;
  if (budget > 0) {
    // A sphere that fills its box has about six triangles for each cell of a side.
    const double coarse = std::sqrt(static_cast<double>(budget) / 6);
    resolution = std::clamp(static_cast<std::size_t>(coarse), std::size_t{least_resolution}, asked);
  }
  for (;;) {
    ImplicitSurface surface = implicit_mesh(field,
                                            {center - 0.5 * in.size, center + 0.5 * in.size, resolution,
                                             most_vertices(resolution), most_field_bytes(*field, resolution)},
                                            context.cancel());
    if (surface.too_large) {
      return Failure{"limit-exceeded",
                     "the surface is so large or so folded that it would have more than " +
                         std::to_string(most_vertices(resolution)) + " vertices; take a larger box or fewer cells",
                     "resolution"};
    }
    const std::size_t triangles = surface.mesh.triangles.size();
    if (budget > 0 && triangles > budget && resolution > std::size_t{least_resolution} && !context.cancel().stopped()) {
      const double share = std::sqrt(static_cast<double>(budget) / static_cast<double>(triangles));
      const auto fewer = static_cast<std::size_t>(0.97 * share * static_cast<double>(resolution));
      resolution = std::clamp(fewer, std::size_t{least_resolution}, resolution - 1);
      continue;
    }
    if (surface.mesh.triangles.empty()) context.warn({"empty", "there is no surface in the box", "size"});
    if (surface.capped) {
      context.warn({"capped", "the solid reaches the border of the box, and is closed there", "size"});
    }
    return std::make_shared<const Mesh>(std::move(surface.mesh));
  }
}

/// Sampling and vertices, for a field of some dozen operations. Fields count themselves what is left of large ones.
RunCost cost_of_implicit(const RunSize& size) {
  const double field_bytes = 2 * (least_field_bytes + field_bytes_of_vertex * size.vertices);
  return {400 * size.vertices, 220 * size.vertices + field_bytes};
}

}  // namespace

void add_implicit_surface(Registry& registry) {
  registry.add(
      node("implicit", implicit_surface)
          .title("Implicit surface")
          .family("implicit")
          .synonyms({"isosurface", "marching cubes", "dual contouring", "field to mesh"})
          .doc("The mesh of the surface of a field within a box.")
          .source("Ju, Losasso, Schaefer, Warren, Dual Contouring of Hermite Data (2002); Nielson, Dual Marching Cubes "
                  "(2004)")
          .details(
              "Closed and two-manifold whatever the field is: each edge has two triangles. Edges and corners of the "
              "solid are kept. Where it is smooth, faces are within a third of cell^2 / radius of curvature of the "
              "surface, vertices within a fiftieth. What is smaller than a cell may be missed, or joined to what is "
              "beside it. A solid that reaches the border of the box is closed there, with a warning. Only cells where "
              "the bounds of the field allow a surface are looked at.")
          .input("field", "The field.")
          .input("center", &ImplicitInputs::center, "Center of the box.",
                 defaults({0, 0, 0}).unit("m").position_handle())
          .input("size", &ImplicitInputs::size, "Its sides, along the axes.", defaults({4, 4, 4}).unit("m"))
          .input("resolution", &ImplicitInputs::resolution, "Cells along the longest side.",
                 defaults(64).hard(least_resolution, 512).soft(16, 256))
          .vertices([](const Literals& literals, const Axes&) {
            return most_vertices(static_cast<std::size_t>(integer_at(literals, "resolution")));
          })
          .thinned_to(2 * vertices_per_cell_of_side * least_resolution * least_resolution)
          .cost(cost_of_implicit)
          .output("mesh", "The mesh, closed."));
}

}  // namespace dini

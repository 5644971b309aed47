// Meshes made, refined and colored.

#include <algorithm>
#include <cmath>

#include "geometry/box.h"
#include "geometry/curvature.h"
#include "geometry/palette.h"
#include "geometry/subdivide.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/costs.h"

namespace dini {

enum class CurvatureKind { gauss, mean };

template <>
struct ChoiceNames<CurvatureKind> {
  static constexpr std::array<std::string_view, 2> names = {"gauss", "mean"};
};

template <>
struct ChoiceNames<Palette> {
  static constexpr std::array<std::string_view, 3> names = {"diverging", "sequential", "cyclic"};
};

namespace {

constexpr const char* palette_doc =
    "Diverging: blue over white to red; sequential: violet over green to yellow; cyclic: all hues, alike at both ends.";

struct BoxMeshInputs {
  Point center;
  Vector size;
  std::int64_t segments;
};

Attempt<SharedMesh> box(const Context& context, const BoxMeshInputs& in) {
  const auto& [center, size, segments] = in;
  if (!(size.x > 0) || !(size.y > 0) || !(size.z > 0)) {
    return Failure{"degenerate", "the edges of a box must have positive lengths", "size"};
  }
  // Two triangles for each of the quads on six faces.
  auto used = static_cast<std::size_t>(segments);
  if (const std::size_t budget = context.triangle_budget(); budget > 0) {
    used = std::clamp<std::size_t>(static_cast<std::size_t>(std::sqrt(static_cast<double>(budget) / 12)), 1, used);
  }
  return std::make_shared<const Mesh>(box_mesh(center, size, used, context.cancel()));
}

struct SubdivideInputs {
  std::int64_t levels;
};

SharedMesh subdivided(const Context& context, const SharedMesh& shape, const SubdivideInputs& in) {
  const std::size_t budget = context.triangle_budget();
  std::size_t used = 0;
  for (std::size_t triangles = 4 * shape->triangles.size(); used < static_cast<std::size_t>(in.levels);
       triangles *= 4) {
    if (budget != 0 && triangles > budget) break;
    ++used;
  }
  if (used == 0) return shape;
  return std::make_shared<const Mesh>(subdivide(*shape, used, context.cancel()));
}

struct CurvatureColorInputs {
  CurvatureKind kind;
  double range;
  Palette palette;
};

std::tuple<SharedMesh, double, double> colored_by_curvature(const Context& context, const SharedMesh& shape,
                                                            const CurvatureColorInputs& in) {
  const Curvatures estimated = estimate_curvatures(*shape, context.cancel());
  const Zeroed<double>& values = in.kind == CurvatureKind::gauss ? estimated.gauss : estimated.mean;
  if (values.empty()) return {shape, 0.0, 0.0};
  CancelEvery steps(context.cancel());
  double least = values[0], most = values[0];
  for (const double value : values) {
    if (steps.stopped()) break;
    if (value < least) least = value;
    if (value >= most) most = value;
  }
  const double bound = in.range > 0 ? in.range : std::max(-least, most);
  auto copy = std::make_shared<Mesh>(*shape);
  copy->colors.clear();
  copy->colors.reserve(values.size());
  for (const double value : values) {
    if (steps.stopped()) break;
    copy->colors.push_back(palette_color(in.palette, bound > 0 ? 0.5 + 0.5 * value / bound : 0.5));
  }
  return {copy, least, most};
}

struct ColorByInputs {
  double value;
  double minimum, maximum;
  Palette palette;
};

SharedMesh colored_by_number(const SharedMesh& shape, const ColorByInputs& in) {
  const auto& [value, minimum, maximum, palette] = in;
  double place = minimum == maximum ? 0.5 : (value - minimum) / (maximum - minimum);
  // Differences of numbers near the largest overflow; those of their quarters do not.
  if (!std::isfinite(place)) place = (value / 4 - minimum / 4) / (maximum / 4 - minimum / 4);
  const std::array<float, 4> color = palette_color(palette, place);
  auto copy = std::make_shared<Mesh>(*shape);
  copy->colors.clear();
  std::copy(color.begin(), color.end(), copy->color.begin());
  return copy;
}

std::size_t box_vertices(const Literals& literals, const Axes&) {
  const auto points = static_cast<std::size_t>(integer_at(literals, "segments") + 1);
  return 6 * points * points;
}

std::size_t subdivided_factor(const Literals& literals) {
  return std::size_t{1} << static_cast<std::size_t>(2 * integer_at(literals, "levels"));
}

}  // namespace

void add_mesh_tools(Registry& registry) {
  registry.add(
      node("box_mesh", box)
          .title("Box mesh")
          .family("meshes")
          .synonyms({"cube", "block", "cuboid", "brick"})
          .doc("A box as a mesh with flat faces.")
          .details("Edges that are not positive are an error. Faces have vertices of their own along common edges.")
          .input("center", &BoxMeshInputs::center, "Its center.", defaults({0, 0, 0}).unit("m").position_handle())
          .input("size", &BoxMeshInputs::size, "Lengths of its edges.", defaults({1, 1, 1}).unit("m"))
          .input("segments", &BoxMeshInputs::segments, "Quads along each edge; more of them bend better.",
                 defaults(16).hard(1, 512).soft(1, 128))
          .vertices(box_vertices)
          .thinned_to(12)
          .cost([](const RunSize& size) {
            return RunCost{0, 64 * size.vertices};
          })
          .output("mesh", "The mesh."));

  registry.add(
      node("subdivide", subdivided)
          .title("Subdivide")
          .family("meshes")
          .synonyms({"refine", "smooth", "tessellate", "more triangles"})
          .doc("Cuts every triangle of a mesh into four, so that it can bend.")
          .details("The shape stays the same. Normals, texture coordinates and colors are averaged along edges.")
          .input("shape", "The mesh.")
          .input("levels", &SubdivideInputs::levels, "How many times; each makes four triangles of one.",
                 defaults(1).hard(0, 6).soft(0, 4))
          .vertex_factor(subdivided_factor)
          .thinned_to(1)
          .cost([](const RunSize& size) {
            return RunCost{250 * size.vertices, 120 * size.vertices};
          })
          .output("shape", "The finer mesh."));

  registry.add(
      node("curvature_color", colored_by_curvature)
          .title("Curvature color")
          .family("meshes")
          .synonyms({"heat map", "analysis", "gauss", "mean curvature", "zebra"})
          .doc("Colors a mesh by its Gauss or mean curvature, and tells the extremes.")
          .source("Rusinkiewicz, Estimating curvatures and their derivatives on triangle meshes (2004)")
          .details("Curvatures are estimated from the triangles around each vertex; the error falls with the "
                   "square of their size, "
                   "at borders with the size. The middle of the palette is zero curvature. The mean curvature "
                   "of a sphere with "
                   "outward faces is +1/radius. A mesh without vertices has the extremes 0.")
          .input("shape", "The mesh.")
          .input("kind", &CurvatureColorInputs::kind, "Product or mean of the principal curvatures.", defaults("gauss"))
          .input("range", &CurvatureColorInputs::range,
                 "Curvature at the ends of the palette; 0 means the largest magnitude found.",
                 defaults(0).hard(0, 1e9).soft(0, 10))
          .input("palette", &CurvatureColorInputs::palette, palette_doc, defaults("diverging"))
          .cost([](const RunSize& size) {
            return RunCost{200 * size.vertices, 120 * size.vertices};
          })
          .output("shape", "The colored mesh.")
          .output("minimum", "Least curvature, in 1/m for mean and 1/m^2 for Gauss.")
          .output("maximum", "Greatest curvature."));

  registry.add(
      node("color_by", colored_by_number)
          .title("Color by number")
          .family("meshes")
          .synonyms({"gradient", "heat map", "palette", "rainbow", "ramp"})
          .doc("Gives each mesh of a family the color of a number on a palette.")
          .details("Numbers outside the range take the nearer end, or go around on the cyclic palette. With "
                   "equal ends every number takes the middle.")
          .input("shape", "The mesh.")
          .input("value", &ColorByInputs::value, "The number.")
          .input("minimum", &ColorByInputs::minimum, "Number at the start of the palette.", defaults(0).soft(-10, 10))
          .input("maximum", &ColorByInputs::maximum, "Number at its end.", defaults(1).soft(-10, 10))
          .input("palette", &ColorByInputs::palette, palette_doc, defaults("cyclic"))
          .cost(cost_of_shared_mesh)
          .output("shape", "The colored mesh."));
}

}  // namespace dini

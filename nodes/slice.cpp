// Where a plane cuts a mesh.

#include "geometry/contours.h"
#include "graph/node_builder.h"
#include "nodes/all.h"

namespace dini {

namespace {

struct SliceInputs {
  double height;
  Vector normal;
  double contour;
  std::int64_t count;
};

Attempt<std::tuple<Made<Point>, double, double, double>> sliced(const Context& context, const SharedMesh& shape,
                                                                const SliceInputs& in) {
  if (in.normal == Vector{}) return Failure{"degenerate", "the normal of the plane must not be zero", "normal"};
  const std::vector<Contour> contours = contours_of(*shape, normalized(in.normal), in.height, context.cancel());
  double area = 0;
  for (const Contour& contour : contours) area += contour.area;
  const auto count = static_cast<std::size_t>(in.count);
  const auto number = static_cast<std::size_t>(in.contour);
  const auto found = static_cast<double>(contours.size());
  if (number < contours.size()) {
    const Contour& asked = contours[number];
    return std::tuple{Made<Point>{contour_points(asked, count, context.cancel())}, asked.length, area, found};
  }
  Made<Point> nothing{Column<Point>(count)};
  CancelEvery looks(context.cancel());
  for (std::size_t i = 0; i < count && !looks.stopped(); ++i) nothing.values.set(i, Point::at_infinity());
  return std::tuple{std::move(nothing), 0.0, area, found};
}

std::vector<Axes> axes_of_slice(const Literals& literals, const std::string& id) {
  const std::string& name = text_at(literals, "axis");
  return {{{name.empty() ? id : name, static_cast<std::size_t>(integer_at(literals, "count")), true}}};
}

}  // namespace

void add_slice(Registry& registry) {
  registry.add(
      node("slice", sliced)
          .title("Slice")
          .family("meshes")
          .synonyms({"section", "cut", "contour", "layers", "cross section", "level", "profile"})
          .doc("The contour in which a plane cuts a mesh: points along a new closed axis, its length, and the area of "
               "the section.")
          .details(
              "Contours are numbered from the longest, 0. Over a range of heights this gives a stack of them; over "
              "a range of numbers all contours of a height. A number that is not there gives points at "
              "infinity and the length 0. Points are at about even lengths, and every corner is among them where "
              "there are no more corners than points. Where the mesh is open a contour has two ends, and its "
              "points run there and back. Corners in the plane count as above it: of a solid that stands in the "
              "plane there is no contour, of one that ends in it there is. Contours run counter-clockwise around "
              "material, seen against the normal, and clockwise around holes.")
          .degenerate("zero direction", "A zero normal is an error.")
          .input("shape", "The mesh.")
          .input("height", &SliceInputs::height, "Of the plane above the origin, along its normal.",
                 defaults(0).soft(-2, 2).unit("m"))
          .input("normal", &SliceInputs::normal, "Normal of the plane, of any length.",
                 defaults({0, 0, 1}).direction_handle())
          .input("contour", &SliceInputs::contour, "Which one, the longest is 0.", defaults(0).hard(0, 1e6).soft(0, 8))
          .input("count", &SliceInputs::count, "How many points.", defaults(256).hard(2, 1'000'000).soft(8, 1024))
          .made_axis("axis", "Name of the axis; empty means the id of this node.")
          .axes(axes_of_slice)
          .makes_curves()
          .cost([](const RunSize& size) {
            return RunCost{150 * size.given_vertices + 100 * size.values, 160 * size.given_vertices + 64 * size.values};
          })
          .output("points", "The contour, over the new axis.")
          .output("length", "Of the contour, in meters.")
          .output("area", "Of the whole section, in square meters; holes are taken off.")
          .output("contours", "How many there are."));
}

}  // namespace dini

#include "geometry/sampling.h"

#include <algorithm>

#include "algebra/extract.h"
#include "geometry/chunks.h"
#include "graph/node_builder.h"
#include "nodes/all.h"

namespace dini {

namespace {

struct SampleInputs {
  std::int64_t count;
  bool closed;
  double length;
};

Attempt<Made<Point>> circle_samples(const Context& context, const Circle& shape, const SampleInputs& in) {
  const std::optional<CircleCoordinates> found = coordinates(shape);
  if (!found) return Failure{"degenerate", "there is no circle to sample", "shape"};
  const auto size = static_cast<std::size_t>(in.count);
  // Turns of a line run from -1/2 to 1/2, those of a circle from 0 to 1.
  const double start = found->line ? -0.5 : 0.0;
  const Column<double> turns = spaced(start, start + 1, size, in.closed, context.cancel());
  Made<Point> samples{Column<Point>(size)};
  for_chunks(context.cancel(), size, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) samples.values.set(i, point_at(*found, turns[i], in.length));
  });
  return samples;
}

struct GridInputs {
  Point center;
  Vector u_vector, v_vector;
  std::int64_t count_u, count_v;
};

std::tuple<Made<Point>, Made<double>, Made<double>> grid_points(const Context& context, const GridInputs& in) {
  const auto size_u = static_cast<std::size_t>(in.count_u);
  const auto size_v = static_cast<std::size_t>(in.count_v);
  Column<double> u = spaced(0, 1, size_u, false, context.cancel());
  Column<double> v = spaced(0, 1, size_v, false, context.cancel());
  Column<Point> points(size_u * size_v);
  for_chunks(context.cancel(), points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const double right = 2 * u[k / size_v] - 1, ahead = 2 * v[k % size_v] - 1;
      points.set(k, to_point(to_vector(in.center) + right * in.u_vector + ahead * in.v_vector));
    }
  });
  return {Made<Point>{std::move(points)}, Made<double>{std::move(u)}, Made<double>{std::move(v)}};
}

std::vector<Axes> grid_axes(const Literals& literals, const std::string&) {
  const Axis u{text_at(literals, "axis_u"), static_cast<std::size_t>(integer_at(literals, "count_u")), false};
  const Axis v{text_at(literals, "axis_v"), static_cast<std::size_t>(integer_at(literals, "count_v")), false};
  return {{u, v}, {u}, {v}};
}

}  // namespace

void add_sampling(Registry& registry) {
  registry.add(
      node("sample", circle_samples)
          .title("Sample")
          .family("sampling")
          .synonyms({"divide", "resample", "points on curve", "instances", "populate"})
          .doc("Points along a circle, or along a piece of a line, on a new axis.")
          .details("A circle starts at a fixed direction that depends on its normal. A line is sampled about its point "
                   "nearest the origin.")
          .degenerate("circle to line", "A piece of the line about its point nearest the origin.")
          .degenerate("zero radius", "Every point is the center.")
          .input("shape", "A circle or a line.")
          .input("count", &SampleInputs::count, "How many points.", defaults(64).hard(1, 10'000'000).soft(3, 256))
          .input("closed", &SampleInputs::closed,
                 "Whether the last point joins the first; a closed circle does not repeat its start.", defaults(true))
          .input("length", &SampleInputs::length, "Length of the piece of a line.",
                 defaults(10).hard(0, 1e9).soft(0, 20).unit("m").title("Length of line"))
          .made_axis("axis", "Name of the axis; empty means the id of this node.")
          .axes(one_axis("count", "axis", "closed"))
          .makes_curves()
          .cost([](const RunSize& size) {
            return RunCost{200 * size.values, 8 * size.values};
          })
          .output("points", "The points, over the new axis."));

  registry.add(node("grid", grid_points)
                   .title("Grid")
                   .family("sampling")
                   .synonyms({"plane", "lattice", "points", "rows", "array"})
                   .doc("Points of a flat parallelogram over two new axes, with their positions u and v from 0 to 1.")
                   .details("It spans center - u_vector - v_vector to center + u_vector + v_vector. A count of 1 "
                            "stands at the start.")
                   .degenerate("zero direction", "Points repeat along the axis of a zero vector.")
                   .input("center", &GridInputs::center, "The middle.", defaults({0, 0, 0}).unit("m").position_handle())
                   .input("u_vector", &GridInputs::u_vector, "Half the extent along u.",
                          defaults({1, 0, 0}).unit("m").direction_handle("center").title("Half width"))
                   .input("v_vector", &GridInputs::v_vector, "Half the extent along v.",
                          defaults({0, 1, 0}).unit("m").direction_handle("center").title("Half depth"))
                   .input("count_u", &GridInputs::count_u, "How many points along u.",
                          defaults(32).hard(1, 65536).soft(2, 256).title("Points along u"))
                   .input("count_v", &GridInputs::count_v, "How many points along v.",
                          defaults(32).hard(1, 65536).soft(2, 256).title("Points along v"))
                   .made_axis("axis_u", "Name of the u axis.", "u")
                   .made_axis("axis_v", "Name of the v axis.", "v")
                   .axes(grid_axes)
                   .output("points", "The points, over u and v.")
                   .output("u", "0 to 1 over the u axis.")
                   .output("v", "0 to 1 over the v axis."));
}

}  // namespace dini

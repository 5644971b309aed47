#include <cstdint>

#include "geometry/chunks.h"
#include "geometry/mixed_bits.h"
#include "graph/node_builder.h"
#include "nodes/all.h"

namespace dini {

namespace {

/// SplitMix64 by counter: the n-th number of a stream from its seed alone.
std::uint64_t mixed(std::uint64_t seed, std::uint64_t counter) {
  return mixed_bits(seed + (counter + 1) * splitmix_step);
}

/// In [0, 1), a multiple of 2^-53.
double unit_number(std::uint64_t seed, std::uint64_t counter) {
  constexpr double spacing = 1.0 / 9007199254740992.0;
  return static_cast<double>(mixed(seed, counter) >> 11) * spacing;
}

struct RandomInputs {
  std::int64_t count, seed;
  double from, to;
  Point minimum, maximum;
};

std::tuple<Made<double>, Made<Point>> random_samples(const Context& context, const RandomInputs& in) {
  const auto size = static_cast<std::size_t>(in.count);
  // Neighboring seeds must not give shifted copies of one stream.
  const std::uint64_t stream = mixed(static_cast<std::uint64_t>(in.seed), 0);
  const auto between = [](double a, double b, double share) { return (1 - share) * a + share * b; };
  Column<double> values(size);
  Column<Point> points(size);
  for_chunks(context.cancel(), size, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      // Four numbers per sample, so that a longer family starts with the shorter one.
      const std::uint64_t first = 4 * static_cast<std::uint64_t>(i);
      values.set(i, between(in.from, in.to, unit_number(stream, first)));
      points.set(i, {between(in.minimum.x, in.maximum.x, unit_number(stream, first + 1)),
                     between(in.minimum.y, in.maximum.y, unit_number(stream, first + 2)),
                     between(in.minimum.z, in.maximum.z, unit_number(stream, first + 3))});
    }
  });
  return {Made<double>{std::move(values)}, Made<Point>{std::move(points)}};
}

}  // namespace

void add_random(Registry& registry) {
  registry.add(
      node("random", random_samples)
          .title("Random")
          .family("numbers")
          .synonyms({"noise", "scatter", "jitter", "seed", "shuffle", "distribution"})
          .doc("Evenly distributed numbers, and points in a box, along a new axis; the same for the same seed.")
          .source("Steele, Lea and Flood, Fast splittable pseudorandom number generators (2014)")
          .details("The same on every machine. A larger count keeps the samples of a smaller one. When from equals to, "
                   "every "
                   "value is that number; a flat box gives points in its plane.")
          .input("count", &RandomInputs::count, "How many.", defaults(32).hard(1, 10'000'000).soft(1, 256))
          .input("seed", &RandomInputs::seed, "Another seed, other samples.",
                 defaults(1).hard(0, 9'007'199'254'740'991).soft(0, 100))
          .input("from", &RandomInputs::from, "Least number.", defaults(0).soft(-10, 10))
          .input("to", &RandomInputs::to, "Bound of the numbers; it is not reached.", defaults(1).soft(-10, 10))
          .input("minimum", &RandomInputs::minimum, "One corner of the box of the points.",
                 defaults({-1, -1, -1}).unit("m").position_handle())
          .input("maximum", &RandomInputs::maximum, "The opposite corner.",
                 defaults({1, 1, 1}).unit("m").position_handle())
          .made_axis("axis", "Name of the axis; empty means the id of this node.")
          .axes(one_axis("count", "axis", "", 2))
          .output("values", "The numbers, over the new axis.")
          .output("points", "The points, over the same axis."));
}

}  // namespace dini

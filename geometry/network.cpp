#include "geometry/network.h"

#include <algorithm>
#include <array>

#include "geometry/chunks.h"
#include "geometry/point_tree.h"

namespace dini {

namespace {

constexpr std::size_t points_in_chunk = 256;

kernels::ConstPoints row_of(const Column<Point>& points, std::size_t begin) {
  return {points.component(0) + begin, points.component(1) + begin, points.component(2) + begin};
}

kernels::Points row_of(Column<Point>& points, std::size_t begin) {
  return {points.component(0) + begin, points.component(1) + begin, points.component(2) + begin};
}

void find_neighbors(kernels::ConstPoints points, std::size_t size, NeighborTable& table, const Cancel& cancel) {
  const PointTree tree(points, size, cancel);
  for_chunks(cancel, size, points_in_chunk, [&](std::size_t begin, std::size_t end) {
    std::array<std::uint32_t, PointTree::most_neighbors> found{};
    for (std::size_t place = begin; place < end; ++place) {
      tree.find_nearest(place, std::span(found).first(table.each));
      const std::uint32_t i = tree.in_order(place);
      for (std::size_t m = 0; m < table.each; ++m) table.indices[m * size + i] = found[m];
    }
  });
}

}  // namespace

NeighborTable::NeighborTable(std::size_t points, std::size_t neighbors)
    : indices(points * std::max<std::size_t>(1, neighbors)), each(std::max<std::size_t>(1, neighbors)) {
  for (std::size_t m = 0; m < each; ++m) {
    for (std::size_t i = 0; i < points; ++i) indices[m * points + i] = static_cast<std::uint32_t>(i);
  }
}

NeighborTable chain_of(std::size_t points, bool closed) {
  NeighborTable table(points, 2);
  // Of two points each is before and behind the other, and beside it once.
  if (points == 2) closed = false;
  for (std::size_t i = 0; i < points; ++i) {
    if (closed || i > 0) table.indices[i] = static_cast<std::uint32_t>((i + points - 1) % points);
    if (closed || i + 1 < points) table.indices[points + i] = static_cast<std::uint32_t>((i + 1) % points);
  }
  return table;
}

Column<Point> evolve(const Column<Point>& start, std::span<const double> weights,
                     const kernels::NetworkSettings& settings, NeighborSearch search, NeighborTable neighbors,
                     std::size_t rows, const Cancel& cancel) {
  const std::size_t size = weights.size();
  Column<Point> points(rows * size), steps(size);
  for (std::size_t i = 0; i < size && rows > 0; ++i) points.set(i, start[i]);
  for (std::size_t row = 1; row < rows && !cancel.stopped(); ++row) {
    const kernels::ConstPoints before = row_of(std::as_const(points), (row - 1) * size);
    if (search == NeighborSearch::nearest) find_neighbors(before, size, neighbors, cancel);
    const bool listed = search != NeighborSearch::all;
    const kernels::Network network{
        before, weights.data(), size, {listed ? neighbors.indices.data() : nullptr, neighbors.each}};
    const kernels::Points after = row_of(points, row * size), gone = row_of(steps, 0);
    for_chunks(cancel, size, points_in_chunk, [&](std::size_t begin, std::size_t end) {
      kernels::step_network(settings, network, begin, end, gone, after, cancel.for_kernels());
    });
  }
  return points;
}

}  // namespace dini

#include "draco/attribute_symbols.h"

#include <algorithm>

namespace dini {
namespace {

std::array<std::int32_t, 2> range_of(std::span<const kernels::Row> rows, int columns) {
  kernels::Row least = rows[0];
  kernels::Row most = rows[0];
  for (const kernels::Row& row : rows) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      least[column] = std::min(least[column], row[column]);
      most[column] = std::max(most[column], row[column]);
    }
  }
  return {*std::min_element(least.begin(), least.begin() + columns),
          *std::max_element(most.begin(), most.begin() + columns)};
}

}  // namespace

AttributeSymbols parallelogram_symbols(std::span<const kernels::Row> rows, int columns, const VertexOrder& order) {
  constexpr std::size_t stride = kernels::Row().size();
  const std::array<std::int32_t, 2> range = range_of(rows, columns);
  auto values = std::make_unique_for_overwrite<std::uint32_t[]>(rows.size() * stride);
  kernels::predict(rows.data(), order, range[0], range[1], values.get());
  return {Prediction::parallelogram, Transform::wrap, columns, stride, rows.size(), std::move(values), range};
}

AttributeSymbols octahedron_symbols(std::span<const std::array<float, 3>> directions, int bits,
                                    const VertexOrder& order) {
  const Octahedron octahedron(bits);
  const std::size_t count = directions.size();
  const auto coordinates = std::make_unique_for_overwrite<float[]>(3 * count);
  float* const axes[] = {coordinates.get(), coordinates.get() + count, coordinates.get() + 2 * count};
  for (std::size_t i = 0; i < count; ++i) {
    const std::array<float, 3>& direction = directions[order.vertices[i]];
    for (std::size_t axis = 0; axis < 3; ++axis) axes[axis][i] = direction[axis];
  }
  const auto points = std::make_unique_for_overwrite<std::int32_t[]>(2 * (count + 1));
  std::int32_t* const s = points.get();
  std::int32_t* const t = s + count + 1;
  *s = *t = 0;  // where the first step begins
  kernels::octahedron_points(octahedron, {axes[0], axes[1], axes[2]}, count, s + 1, t + 1);
  auto values = std::make_unique_for_overwrite<std::uint32_t[]>(2 * count);
  kernels::octahedron_steps(octahedron, s, t, count, values.get());
  return {Prediction::difference,
          Transform::octahedron,
          2,
          2,
          count,
          std::move(values),
          {octahedron.steps(), octahedron.center()}};
}

}  // namespace dini

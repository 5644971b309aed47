#include "draco/attribute_symbols.h"

#include <algorithm>

namespace dini {
namespace {

/// Differences modulo the range of the values, as near to 0 as they go, then without sign: 0, -1, 1, -2, ...
class Wrap {
 public:
  explicit Wrap(std::span<const std::int32_t> values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    minimum_ = *least;
    maximum_ = *most;
    count_ = 1 + maximum_ - minimum_;
    highest_ = (count_ - 1) / 2;
    lowest_ = highest_ + 1 - count_;
  }

  std::uint32_t symbol(std::int32_t value, std::int32_t predicted) const {
    std::int32_t left = value - std::clamp(predicted, minimum_, maximum_);
    if (left > highest_) left -= count_;
    if (left < lowest_) left += count_;
    return static_cast<std::uint32_t>(left >= 0 ? 2 * left : -2 * left - 1);
  }

  std::array<std::int32_t, 2> range() const { return {minimum_, maximum_}; }

 private:
  std::int32_t minimum_ = 0, maximum_ = 0, count_ = 0, lowest_ = 0, highest_ = 0;
};

template <std::size_t columns>
void predict(std::span<const std::int32_t> values, const VertexOrder& order, const Wrap& wrap, std::uint32_t* symbols) {
  for (std::size_t column = 0; column < columns; ++column) {
    symbols[column] = wrap.symbol(values[order.vertices[0] * columns + column], 0);
  }
  for (std::size_t i = 1; i < order.vertices.size(); ++i) {
    const auto& [after, before, across] = order.parallelograms[i];
    const std::int32_t* own = &values[order.vertices[i] * columns];
    const std::int32_t* a = &values[after * columns];
    const std::int32_t* b = &values[before * columns];
    const std::int32_t* c = &values[across * columns];
    for (std::size_t column = 0; column < columns; ++column) {
      symbols[i * columns + column] = wrap.symbol(own[column], a[column] + b[column] - c[column]);
    }
  }
}

}  // namespace

AttributeSymbols parallelogram_symbols(std::span<const std::int32_t> values, int columns, const VertexOrder& order) {
  AttributeSymbols result = {Prediction::parallelogram, Transform::wrap, columns, {}, {}};
  const Wrap wrap(values);
  result.range = wrap.range();
  result.values.resize(values.size());
  switch (columns) {
    case 2: predict<2>(values, order, wrap, result.values.data()); break;
    case 3: predict<3>(values, order, wrap, result.values.data()); break;
    default: predict<4>(values, order, wrap, result.values.data()); break;
  }
  return result;
}

AttributeSymbols octahedron_symbols(std::span<const std::array<float, 3>> directions, int bits,
                                    const VertexOrder& order) {
  AttributeSymbols result = {Prediction::difference, Transform::octahedron, 2, {}, {}};
  const Octahedron octahedron(bits);
  result.range = {octahedron.steps(), octahedron.center()};
  result.values.resize(2 * directions.size());
  SquarePoint last;
  for (std::size_t i = 0; i < order.vertices.size(); ++i) {
    const SquarePoint point = octahedron.point(directions[order.vertices[i]]);
    const SquarePoint step = octahedron.step(last, point);
    result.values[2 * i] = static_cast<std::uint32_t>(step.s);
    result.values[2 * i + 1] = static_cast<std::uint32_t>(step.t);
    last = point;
  }
  return result;
}

}  // namespace dini

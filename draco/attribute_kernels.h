#pragma once

// What is done to every vertex of a tile on the way into a stream, by the widest instruction set of the processor
// (Highway). Every instruction set gives the same numbers: nothing is fused, and rounding is that of the decoder.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "draco/octahedron.h"
#include "draco/vertex_order.h"

namespace dini::kernels {

/// The numbers of one vertex, the last ones unused where there are fewer than four.
using Row = std::array<std::int32_t, 4>;

/// Where values lie on a grid: at `origin` plus whole steps.
struct Steps {
  std::array<float, 4> origin;
  float per_unit;
};

/// The steps of each value of 2 or 3 numbers, rounded in single precision, halves upward. No value is below the origin.
void quantize(std::span<const std::array<float, 2>> values, const Steps& steps, Row* rows);
void quantize(std::span<const std::array<float, 3>> values, const Steps& steps, Row* rows);

/// What is left of each row when its parallelogram is taken from it, in the order of decoding: modulo `maximum -
/// minimum
/// + 1`, as near to 0 as that goes, then without sign (0, -1, 1, -2, ... become 0, 1, 2, 3, ...). The first row is
/// predicted as zeros. All numbers lie in `minimum` to `maximum`.
void predict(const Row* rows, const VertexOrder& order, std::int32_t minimum, std::int32_t maximum,
             std::uint32_t* left);

/// `Octahedron::point` of each direction, the directions and the points by coordinates.
void octahedron_points(const Octahedron& octahedron, const float* const (&directions)[3], std::size_t count,
                       std::int32_t* s, std::int32_t* t);

/// `Octahedron::step` from each point to the next, `count` of them, so that `count + 1` points are read.
void octahedron_steps(const Octahedron& octahedron, const std::int32_t* s, const std::int32_t* t, std::size_t count,
                      std::uint32_t* steps);

}  // namespace dini::kernels

#pragma once

// The attributes of vertices as small numbers: what is left of each when a decoder's prediction is taken from it.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "draco/byte_writer.h"
#include "draco/octahedron.h"
#include "draco/symbol_coding.h"
#include "draco/vertex_order.h"

namespace dini {

/// How decoders predict (bitstream 2.2, "Prediction encoding methods").
enum class Prediction : std::int8_t { difference = 0, parallelogram = 1 };

/// How decoders add what is left (bitstream 2.2, "Prediction scheme transform methods").
enum class Transform : std::int8_t { wrap = 1, octahedron = 3 };

/// One attribute of all vertices in the order of decoding.
struct AttributeSymbols {
  Prediction prediction = Prediction::parallelogram;
  Transform transform = Transform::wrap;
  int columns = 0;
  std::vector<std::uint32_t> values;
  std::array<std::int32_t, 2> range = {};  ///< of the attribute (wrap), or its steps and their center (octahedron)

  SymbolRows rows() const { return {values, columns}; }
};

/// Whole numbers predicted by parallelograms; `values` has `columns` (2 to 4) for each vertex of the mesh, from 0 to
/// 2^20. What is left is counted modulo the range of all values, and kept without sign.
AttributeSymbols parallelogram_symbols(std::span<const std::int32_t> values, int columns, const VertexOrder& order);

/// Unit vectors, one for each vertex of the mesh, as steps on the octahedron from the one decoded before.
AttributeSymbols octahedron_symbols(std::span<const std::array<float, 3>> directions, int bits,
                                    const VertexOrder& order);

}  // namespace dini

#pragma once

// The attributes of vertices as small numbers: what is left of each when a decoder's prediction is taken from it.

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "draco/attribute_kernels.h"
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
  std::size_t stride = 0;
  std::size_t count = 0;  ///< of vertices
  std::unique_ptr<std::uint32_t[]> values;
  std::array<std::int32_t, 2> range = {};  ///< of the attribute (wrap), or its steps and their center (octahedron)

  SymbolRows rows() const { return {values.get(), count, columns, stride}; }
};

/// Whole numbers from 0 to 2^20 predicted by parallelograms, `columns` (2 to 4) for each vertex of the mesh. What is
/// left is counted modulo the range of all, and kept without sign.
AttributeSymbols parallelogram_symbols(std::span<const kernels::Row> rows, int columns, const VertexOrder& order);

/// Directions, one for each vertex of the mesh, as steps on the octahedron from the one decoded before.
AttributeSymbols octahedron_symbols(std::span<const std::array<float, 3>> directions, int bits,
                                    const VertexOrder& order);

}  // namespace dini

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "algebra/vector.h"
#include "geometry/measure.h"
#include "geometry/scene.h"

namespace dini {

/// What a model looks like, whatever its parts are called and in whatever order they come: triangles, and the pieces of
/// curves and single points as triangles whose last corners are one. In meters, Z up.
struct Shape {
  using Piece = std::array<std::uint32_t, 3>;

  std::vector<Vector> points;
  std::vector<std::array<float, 4>> colors;  ///< of the points: those of vertices times those of materials
  std::vector<Piece> pieces;                 ///< triangles first, then segments, then points
  std::size_t triangles = 0;
  std::size_t segments = 0;
  Measures measures;  ///< of all triangles together
};

/// The shape of the parts of a model.
Shape shape_of(const std::vector<Part>& parts);

/// The shape of a file that this program wrote as GLB with Draco. Nothing for any other, which it must not be given if
/// it is from outside.
std::optional<Shape> read_shape(std::string_view glb);

}  // namespace dini

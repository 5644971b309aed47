#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polygon.h"
#include "geometry/raw_mesh.h"

namespace dini {

/// Turns the faces of a file into triangles, and counts those that cannot be drawn.
class FaceBuilder {
 public:
  /// Whether a face can be drawn: it has three corners or more, all of them finite and below 1e18. One that cannot is
  /// counted, to be told of by `warn`.
  bool takes(std::span<const Vector> corners);

  /// Adds the triangles of a face that was taken; `vertices` are those of `raw` at its corners.
  void add(std::span<const std::uint32_t> vertices, std::span<const Vector> corners, RawMesh& raw);

  /// Adds a sentence to the warnings for each kind of face that was not taken.
  void warn(std::vector<std::string>& warnings) const;

 private:
  PolygonCutter cutter_;
  std::vector<std::array<std::uint32_t, 3>> pieces_;
  std::size_t too_short_ = 0, out_of_reach_ = 0;
};

}  // namespace dini

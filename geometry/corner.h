#pragma once

#include <algorithm>
#include <array>

#include "geometry/angle.h"
#include "geometry/mesh.h"

namespace dini {

/// The corner positions of a triangle of `mesh`.
inline std::array<Vector, 3> corners_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  return {to_vector(mesh.positions[triangle[0]]), to_vector(mesh.positions[triangle[1]]),
          to_vector(mesh.positions[triangle[2]])};
}

/// `v` with length 1, without the care for extreme lengths that `normalized` takes; zero below 1e-150 and above 1e150.
inline Vector quick_unit(const Vector& v) {
  const double square = squared_length(v);
  return square > 1e-300 && square < 1e300 ? v / std::sqrt(square) : Vector{};
}

/// The unit normal of a triangle times its angle at each corner; zero for a triangle without area.
/// Angle weights do not depend on how a surface around the corner is cut into triangles.
inline std::array<Vector, 3> angle_weighted_normals(const std::array<Vector, 3>& corners) {
  const Vector ab = quick_unit(corners[1] - corners[0]);
  const Vector bc = quick_unit(corners[2] - corners[1]);
  const Vector ca = quick_unit(corners[0] - corners[2]);
  const Vector normal = quick_unit(cross(ab, ca));
  const auto angle = [](const Vector& in, const Vector& out) {
    return angle_of(-dot(in, out), std::sqrt(squared_length(cross(in, out))));
  };
  const double first = angle(ca, ab);
  const double second = angle(ab, bc);
  return {-first * normal, -second * normal, -std::max(0.0, pi - first - second) * normal};
}

}  // namespace dini

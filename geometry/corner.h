#pragma once

#include <array>

#include "geometry/angle.h"
#include "geometry/mesh.h"

namespace dini {

/// The corner positions of a triangle of `mesh`.
inline std::array<Vector, 3> corners_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  return {to_vector(mesh.positions[triangle[0]]), to_vector(mesh.positions[triangle[1]]),
          to_vector(mesh.positions[triangle[2]])};
}

/// The unit normal of a triangle times its angle at each corner; zero for a triangle without area.
/// Angle weights do not depend on how a surface around the corner is cut into triangles.
inline std::array<Vector, 3> angle_weighted_normals(const std::array<Vector, 3>& corners) {
  const Vector ab = normalized(corners[1] - corners[0]);
  const Vector bc = normalized(corners[2] - corners[1]);
  const Vector ca = normalized(corners[0] - corners[2]);
  const Vector normal = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
  const auto angle = [](const Vector& in, const Vector& out) {
    return angle_of(-dot(in, out), std::sqrt(squared_length(cross(in, out))));
  };
  return {angle(ca, ab) * normal, angle(ab, bc) * normal, angle(bc, ca) * normal};
}

}  // namespace dini

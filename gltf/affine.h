#pragma once

#include <array>

#include "algebra/vector.h"

namespace dini {

/// An affine map: `linear` by columns, then `shift`.
struct Affine {
  std::array<Vector, 3> linear = {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
  Vector shift;

  Vector turned(const Vector& v) const { return v.x * linear[0] + v.y * linear[1] + v.z * linear[2]; }
  Vector operator()(const Vector& p) const { return turned(p) + shift; }

  /// A normal's direction: by the cofactors, which agree with the transposed inverse up to a positive factor when the
  /// map keeps the orientation, and exist also where it flattens.
  Vector normal(const Vector& n) const {
    return n.x * cross(linear[1], linear[2]) + n.y * cross(linear[2], linear[0]) + n.z * cross(linear[0], linear[1]);
  }

  bool mirrors() const { return dot(linear[0], cross(linear[1], linear[2])) < 0; }
};

/// First `inner`, then `outer`.
inline Affine after(const Affine& outer, const Affine& inner) {
  return {{outer.turned(inner.linear[0]), outer.turned(inner.linear[1]), outer.turned(inner.linear[2])},
          outer(inner.shift)};
}

}  // namespace dini

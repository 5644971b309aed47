#pragma once

// Products of vectors and bivectors that several constructions need. A sphere or plane is taken as its dual vector.

#include "algebra/elements.h"
#include "algebra/extract.h"

namespace dini {

/// a . b
inline double scalar_product(const Sphere& a, const Sphere& b) { return dot(a.e, b.e) - a.no * b.ni - a.ni * b.no; }

/// a ^ b
inline Generator wedge(const Sphere& a, const Sphere& b) {
  return {a.no * b.e - b.no * a.e, cross(a.e, b.e), a.no * b.ni - a.ni * b.no, b.ni * a.e - a.ni * b.e};
}

/// s . B, a vector: the part of s in the plane of B, turned there.
inline Sphere contraction(const Sphere& s, const Generator& b) {
  return {s.no * b.no_ni - dot(s.e, b.no_e), s.no * b.e_ni - s.ni * b.no_e - cross(s.e, b.e_e),
          dot(s.e, b.e_ni) - s.ni * b.no_ni};
}

/// A circle or line as its dual bivector of square -1, in coordinates whose origin is `origin`; nothing for a circle of
/// radius zero.
std::optional<Generator> unit_dual(const CircleCoordinates& circle, const Vector& origin = {});

}  // namespace dini

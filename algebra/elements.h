#pragma once

// The vocabulary of the conformal model R(4,1): the typed elements that travel through Dini.
//
// Metric: no.ni = -1, no.no = ni.ni = 0. A point is P(x) = no + x + x^2/2 ni, the squared distance of two points is
// -2 P.Q, and 1 - v ni/2 moves by v. Every element states which coefficients it stores and on which blades.
// `docs/conventions.md` is the same page for readers.

#include <limits>

#include "algebra/vector.h"

namespace dini {

/// A position in space, in meters. The one point at infinity has all three coordinates equal to +infinity.
struct Point {
  double x = 0, y = 0, z = 0;

  static constexpr Point at_infinity() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {infinity, infinity, infinity};
  }

  friend constexpr bool operator==(const Point&, const Point&) = default;
};

constexpr Vector to_vector(const Point& p) { return {p.x, p.y, p.z}; }
constexpr Point to_point(const Vector& v) { return {v.x, v.y, v.z}; }
inline bool is_finite(const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// Any bivector of R(4,1): 10 coefficients.
/// `no_e` on no^e1, no^e2, no^e3; `e_e` on e2^e3, e3^e1, e1^e2; `no_ni` on no^ni; `e_ni` on e1^ni, e2^ni, e3^ni.
/// Null, real and imaginary point pairs, flat points p^ni (scaling), directions v^ni (translation), dual lines
/// (rotation) and all their weighted sums are generators.
struct Generator {
  Vector no_e;
  Vector e_e;
  double no_ni = 0;
  Vector e_ni;

  friend constexpr bool operator==(const Generator&, const Generator&) = default;
};

constexpr Generator operator+(const Generator& a, const Generator& b) {
  return {a.no_e + b.no_e, a.e_e + b.e_e, a.no_ni + b.no_ni, a.e_ni + b.e_ni};
}
constexpr Generator operator*(double s, const Generator& a) { return {s * a.no_e, s * a.e_e, s * a.no_ni, s * a.e_ni}; }

/// An oriented circle, or an oriented line (a circle through infinity), stored as its dual bivector
/// (dual sphere) ^ (dual plane). For center c, normal n, radius r that is T(c, n) + r^2/2 n^ni with the null pair
/// T(c, n) = no^n + (c.n) no^ni + c^n + ((c.n) c - c^2/2 n)^ni; the circle runs counter-clockwise about n.
/// For a line through q along u: e_e = u, e_ni = q x u, the rest zero. Any positive multiple is the same circle;
/// a negative multiple is the same circle run the other way.
struct Circle {
  Generator dual;

  friend constexpr bool operator==(const Circle&, const Circle&) = default;
};

/// An oriented sphere or plane, stored as its dual vector no*`no` + `e` + ni*`ni`.
/// Sphere with center c and radius r: no + c + (c^2 - r^2)/2 ni. Plane with unit normal n at distance d: n + d ni.
struct Sphere {
  double no = 0;
  Vector e;
  double ni = 0;

  friend constexpr bool operator==(const Sphere&, const Sphere&) = default;
};

/// An even element of R(4,1): scalar, bivector and the grade-4 part `quad`, which is stored as the dual of a vector
/// (see `algebra/versor.h`). Rotors, motors, boosts and the paper's unnormalized operators 1 + B are versors.
struct Versor {
  double scalar = 1;
  Generator bivector;
  Sphere quad;

  friend constexpr bool operator==(const Versor&, const Versor&) = default;
};

/// How a generator is exponentiated. `exact` is the true exponential. `paper` is eq. 14 of "Boosted Surfaces" as its
/// author computes it: only the scalar part of the square counts. They agree whenever the generator is simple.
enum class Rule { exact, paper };

}  // namespace dini

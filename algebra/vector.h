#pragma once

// Three-dimensional Euclidean vectors: the coordinates that every element of the algebra is built from.

#include <cmath>

namespace dini {

/// A free direction in space, in meters.
struct Vector {
  double x = 0, y = 0, z = 0;

  friend constexpr bool operator==(const Vector&, const Vector&) = default;
};

constexpr Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
constexpr Vector operator*(double s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr Vector operator*(const Vector& a, double s) { return s * a; }
constexpr Vector operator/(const Vector& a, double s) { return {a.x / s, a.y / s, a.z / s}; }

constexpr double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr double squared_length(const Vector& a) { return dot(a, a); }

/// Euclidean length; scales first, so that it neither overflows nor underflows.
double length(const Vector& a);

/// The unit vector along `a`; the zero vector for the zero vector. Exact scaling, no overflow.
Vector normalized(const Vector& a);

/// A unit vector perpendicular to `a`, chosen by a fixed rule; e1 for the zero vector.
Vector any_perpendicular(const Vector& a);

inline bool is_finite(const Vector& a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

}  // namespace dini

#pragma once

#include <cmath>

#include "algebra/vector.h"

namespace dini {

/// A number that depends on a place, with its gradient there: arithmetic on these carries both (forward
/// differentiation), so a formula is written once, as a template, for its values and for its gradients.
struct Slope {
  double value = 0;
  Vector gradient;
};

inline double value_of(double number) { return number; }
inline double value_of(const Slope& number) { return number.value; }

inline Slope operator-(const Slope& a) { return {-a.value, -a.gradient}; }
inline Slope operator+(const Slope& a, const Slope& b) { return {a.value + b.value, a.gradient + b.gradient}; }
inline Slope operator-(const Slope& a, const Slope& b) { return {a.value - b.value, a.gradient - b.gradient}; }
inline Slope operator*(const Slope& a, const Slope& b) {
  return {a.value * b.value, a.value * b.gradient + b.value * a.gradient};
}
inline Slope operator/(const Slope& a, const Slope& b) {
  const double ratio = a.value / b.value;
  return {ratio, (a.gradient - ratio * b.gradient) / b.value};
}
inline Slope operator+(const Slope& a, double b) { return {a.value + b, a.gradient}; }
inline Slope operator+(double a, const Slope& b) { return b + a; }
inline Slope operator-(const Slope& a, double b) { return {a.value - b, a.gradient}; }
inline Slope operator*(double a, const Slope& b) { return {a * b.value, a * b.gradient}; }

inline double magnitude(double number) { return std::abs(number); }
inline Slope magnitude(const Slope& number) { return number.value < 0 ? -number : number; }

inline double root(double number) { return std::sqrt(number); }
/// The gradient of a root of zero is taken as zero.
inline Slope root(const Slope& number) {
  const double value = std::sqrt(number.value);
  return {value, value > 0 ? number.gradient / (2 * value) : Vector{}};
}

/// A place whose coordinates are numbers or slopes.
template <class Number>
struct PlaceOf {
  Number x, y, z;
};

/// The coordinates of a place as slopes.
inline PlaceOf<Slope> sloped(const Vector& place) {
  return {{place.x, {1, 0, 0}}, {place.y, {0, 1, 0}}, {place.z, {0, 0, 1}}};
}

template <class Number>
Number dot(const Vector& a, const PlaceOf<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
Number square(const PlaceOf<Number>& place) {
  return place.x * place.x + place.y * place.y + place.z * place.z;
}

template <class Number>
PlaceOf<Number> operator-(const PlaceOf<Number>& place, const Vector& origin) {
  return {place.x - origin.x, place.y - origin.y, place.z - origin.z};
}

}  // namespace dini

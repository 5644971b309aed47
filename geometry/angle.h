#pragma once

// Sines, cosines and angles from additions, products, divisions and square roots only, so that meshes come out bit by
// bit the same on every machine; the functions of the platform's mathematics library do not promise that.

#include "algebra/vector.h"

namespace dini {

inline constexpr double pi = 3.14159265358979323846;

struct SineCosine {
  double sine = 0, cosine = 1;
};

/// Sine and cosine of `turns` full turns, within 3e-16; exact at quarter turns. `turns` finite and below 1e15.
SineCosine sine_cosine(double turns);

/// The angle in [0, pi] of the direction (x, y) from the x axis, y >= 0, within 1e-15; 0 for (0, 0).
double angle_of(double x, double y);

/// The angle in [0, pi] between two directions of any length, within 1e-15; 0 when one of them is zero.
double angle_between(const Vector& a, const Vector& b);

}  // namespace dini

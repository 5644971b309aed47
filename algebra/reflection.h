#pragma once

// Reflections in planes and inversions in spheres: the odd versors, which turn space inside out.

#include "algebra/elements.h"

namespace dini {

/// True for a sphere with a radius, or a plane: what space can be reflected in.
bool is_mirror(const Sphere& mirror);

// Every function below takes such a mirror. With s the mirror, x goes to -s x ~s / s^2. In a sphere with center c and
// radius r a point goes to c + r^2 (p - c) / |p - c|^2; the center goes to infinity, and infinity to the center.

Point reflect(const Sphere& mirror, const Point& point);

/// The reflected generator moves the reflected shape as the generator moves the shape: tangents are carried with their
/// points, and turns change their sense.
Generator reflect(const Sphere& mirror, const Generator& generator);

/// The circle through the reflected points, run in their order.
Circle reflect(const Sphere& mirror, const Circle& circle);

/// The sphere through the reflected points; what was on its positive side (within a sphere, ahead of a plane) still is.
Sphere reflect(const Sphere& mirror, const Sphere& sphere);

/// Differential of the reflection, at `point`, of a direction there, divided by the factor of its length. The zero
/// vector where the point goes to infinity or comes from there.
Vector reflect_at(const Sphere& mirror, const Point& point, const Vector& direction);

}  // namespace dini

#pragma once

// The generator that takes one element to another: exp(B) does it, and exp(amount B) goes part of the way.

#include <optional>

#include "algebra/elements.h"

namespace dini {

/// The logarithm of a rotor: exp of it acts as the rotor does. Of two turns the shorter ones are meant. Nothing where
/// V ~V is no positive scalar, and where two commuting turns leave no choice (both half turns).
std::optional<Generator> rotor_logarithm(const Versor& rotor);

/// From circle to circle by a turn, a shift and a scaling in one: a spiral about the point that stays. The turn is the
/// shorter one between the normals. Between lines it is the motor of `motor_between`. Orientation is carried. Nothing
/// from a line to a circle or back, and for circles of radius zero.
std::optional<Generator> similarity_between(const Circle& from, const Circle& to);

/// From circle to circle, or line, by the square root of their ratio, the rotor that moves nothing beyond what both
/// span. A circle and itself run the other way: half a turn about a diameter chosen by a fixed rule. Nothing for
/// circles of radius zero, and where there is no choice even so.
std::optional<Generator> rotor_between(const Circle& from, const Circle& to);

/// From sphere to sphere, or plane, by the square root of their ratio: `factor` times `plane`. Orientation does not
/// count: the nearer of the two ways is taken. Nothing for spheres of radius zero.
struct SphereRatio {
  double factor = 0;
  Generator plane;  ///< the product of both, of size one
};
std::optional<SphereRatio> sphere_ratio(const Sphere& from, const Sphere& to);

}  // namespace dini

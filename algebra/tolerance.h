#pragma once

// Every epsilon of the algebra. None is absolute: each multiplies the size of the data it is compared with.

#include <limits>

namespace dini::tolerance {

inline constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

/// Squares of generators: B.B = e^2 - W^2 - 2 A.M and the square of B^B are sums of four products of rounded sums. Each
/// product carries about three roundings, so what is below 32 units of their magnitudes (squared, for B^B) is noise and
/// counts as zero: a null pair far from the origin stays exactly null.
inline constexpr double square_noise = 32 * unit_roundoff;

/// A circle is a line when its weight |no_e| is below this share of its size sqrt(-B.B) (their ratio is the radius, in
/// meters): beyond radius R = 6.7e10 m, points center + R (cos, sin) are off by R * unit_roundoff = 7 micrometers or
/// more, and the line is off by no more than that over the nearest kilometer, L^2 / (2 R). A boost that should give a
/// line leaves such weights: the circle of radius r at distance c from the origin is stored to c^2 * unit_roundoff, and
/// comes out with radius r^3 / (c^2 * unit_roundoff).
inline constexpr double line_weight = 1.5e-11;

/// The same for spheres and planes: |no| against the size sqrt(s.s).
inline constexpr double plane_weight = line_weight;

/// A squared radius may come out negative by this share of the terms it is the difference of; it then counts as zero.
inline constexpr double square_radius_noise = 64 * unit_roundoff;

/// Three points are collinear when the sine of their angle is below the round-off of the cross product of differences.
inline constexpr double collinear = 16 * unit_roundoff;

/// A generator is the null pair at a position when its coefficients agree with those of the pair to a few roundings
/// each, also when the position itself was recovered from them.
inline constexpr double null_pair = 32 * unit_roundoff;

/// V ~V may differ from a scalar, and a motor from its pattern of zeros, by this share of V's coefficients: a few dozen
/// products.
inline constexpr double versor = 1e-12;

/// Directions opposite up to this sine get the half turn. The rotation axis is their cross product, whose direction is
/// known only to unit_roundoff / sine; at the square root the error of either choice is the same, 10^-8.
inline constexpr double opposite_directions = 1.5e-8;

/// exp(B) is divided by cosh of its hyperbolic argument beyond this: V x ~V then stays far below overflow.
inline constexpr double largest_hyperbolic_argument = 300;

/// Coefficients above this are scaled down before their fourth powers are taken; such generators have saturated.
inline constexpr double saturated_generator = 1e60;

/// Guards against dividing by products that underflow, far below anything that could matter beside 1: arguments of sine
/// and cosine, and their squares.
inline constexpr double vanishing_argument = 1e-100;
inline constexpr double vanishing_square = 1e-200;

/// An image this much nearer to the origin than its point (squared) is computed by itself: as a sum of the point and a
/// displacement it would have only the digits that the point leaves over.
inline constexpr double much_nearer = 1.0 / 64;

/// A generator is taken to a far point, to be exponentiated there, when that makes the terms of its square no larger
/// than this times what they are; beyond, more digits are lost on the way than by looking at the point from afar.
inline constexpr double seen_from_afar = 16;

/// Points farther out than this, in meters, count as the point at infinity: cubes of coordinates must stay finite.
inline constexpr double infinite_distance = 1e100;

/// When the sums of a warp overflow, a point within this distance of a generator of weight 1/d^p is at it, and stays:
/// the displacement is of the order of the distance.
inline constexpr double at_generator = 1e-50;

}  // namespace dini::tolerance

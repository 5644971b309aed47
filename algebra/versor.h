#pragma once

// Even elements: composing them, applying them, exponentials, logarithms, square roots.

#include <optional>

#include "algebra/elements.h"

namespace dini {

// The grade-4 part of a versor is stored as the vector v = `quad` with (grade-4 part) = v I, I = e1 e2 e3 (no^ni). I
// commutes with everything and I I = -1, so `quad` moves like a vector. On blades, v = alpha no + y + beta ni stands
// for
//   -alpha e123^no + beta e123^ni + (y.x e23 + y.y e31 + y.z e12)^no^ni.

/// The exponential of any generator. `exact` goes through the split into commuting parts and is right for null, simple,
/// isoclinic and nearly degenerate generators (Dorst and Valkenburg 2011). `paper` is eq. (14): cosh/cos/1 plus
/// sinh/sin/1 times B with the square taken as its scalar part; its result is rescaled so that it never overflows
/// (the action does not depend on scale).
Versor exponential(const Generator& generator, Rule rule = Rule::exact);

/// Geometric product a b: applying it applies b first.
Versor compose(const Versor& a, const Versor& b);
Versor reverse(const Versor& versor);

/// Versor plus scalar and bivector only: the paper's K = s + B (eqs. 5, 20).
Versor versor_from(double scalar, const Generator& bivector);

/// V x ~V for every kind of element. Generators, circles and spheres are divided by the scalar part of V ~V (when it is
/// not zero), so that unnormalized versors keep their strength, scale and orientation. For points the result is the
/// center of the resulting dual sphere, so that the unnormalized and the paper's operators work too; a zero weight is
/// the point at infinity. A point at infinity is carried like any other. A zero versor gives nothing, as does a point
/// whose image has neither weight nor direction.
std::optional<Point> apply(const Versor& versor, const Point& point);
Generator apply(const Versor& versor, const Generator& generator);
Circle apply(const Versor& versor, const Circle& circle);
Sphere apply(const Versor& versor, const Sphere& sphere);

/// Differential of the action on points, at `point`, of a direction there: what happens to a tangent or a normal.
/// Versor actions are conformal, so normals may be carried the same way and normalized.
Vector apply_at(const Versor& versor, const Point& point, const Vector& direction);

/// True when V ~V is more than the round-off of its own terms: else V takes everything to one point.
bool has_inverse(const Versor& versor);

/// True when V ~V is a nonzero scalar to round-off.
bool is_versor(const Versor& versor);

/// The motor that turns by `angle` (radians, right hand) about the line `axis` while sliding `slide` along it.
/// An axis that is no line gives the identity.
Versor screw_motor(const Circle& axis, double angle, double slide);
Versor translation_versor(const Vector& by);
Versor scaling_versor(const Point& center, double factor);

/// The logarithm of a motor (a generator B with exponential(B) equal to it up to scale), the turn in [0, pi].
/// Nothing when the versor is no motor.
std::optional<Generator> motor_logarithm(const Versor& motor);

/// The shortest motor from one oriented line to another (paper, eq. 11): turns by the angle between the directions
/// about the common perpendicular and slides along it. Parallel lines: pure translation. Opposite lines: a half turn
/// about the axis perpendicular to both, chosen by a fixed rule. Nothing when an argument is no line.
std::optional<Versor> motor_between(const Circle& from, const Circle& to);

}  // namespace dini

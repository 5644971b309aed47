#include <cmath>

#include "algebra/construct.h"
#include "algebra/elementary.h"
#include "algebra/extract.h"
#include "algebra/tolerance.h"
#include "algebra/versor.h"

namespace dini {

namespace {

constexpr double pi = 3.14159265358979311600;

/// A motor as a rotation (scalar, W) and its dual part (-quad.ni, e_ni), divided by the size of the rotation.
struct MotorParts {
  double scalar;
  Vector turn;
  double dual_scalar;
  Vector dual_turn;
};

std::optional<MotorParts> motor_parts(const Versor& v) {
  const Generator& g = v.bivector;
  const double size = std::sqrt(v.scalar * v.scalar + squared_length(g.e_e));
  const double rest = length(g.no_e) + std::abs(g.no_ni) + std::abs(v.quad.no) + length(v.quad.e);
  const double total = size + length(g.e_ni) + std::abs(v.quad.ni);
  if (!(size > 0) || !std::isfinite(total) || rest > tolerance::versor * total) return std::nullopt;
  return MotorParts{v.scalar / size, g.e_e / size, -v.quad.ni / size, g.e_ni / size};
}

/// The logarithm with half a turn |W| up to pi: exp of (W, M) has rotation cos + W sinc and dual part the derivative of
/// that.
Generator logarithm(const MotorParts& motor) {
  const double sine = length(motor.turn);
  if (sine == 0) return direction_generator(motor.dual_turn);
  const double half_angle = elementary::atan2(sine, motor.scalar);
  const Vector axis = motor.turn / sine;
  const double along = dot(axis, motor.dual_turn);
  const double slide = along * motor.scalar - motor.dual_scalar * sine;
  return {{}, half_angle * axis, 0, slide * axis + (half_angle / sine) * (motor.dual_turn - along * axis)};
}

}  // namespace

Versor screw_motor(const Circle& axis, double angle, double slide) {
  const auto line = coordinates(axis);
  if (!line || !line->line) return {};
  const Vector u = line->direction;
  return exponential(
      {{}, (-0.5 * angle) * u, 0, (-0.5 * angle) * cross(to_vector(line->point), u) - (0.5 * slide) * u});
}

Versor translation_versor(const Vector& by) { return {1, direction_generator(-0.5 * by), {}}; }

Versor scaling_versor(const Point& center, double factor) {
  // s + e p^ni with (s + e) / (s - e) = f: the exponential of log(f)/2 p^ni up to scale; it also exists for f <= 0.
  // Only this ratio counts, so the smaller of the two is made exactly 1: of a large f as a difference of halves of
  // sums, digits would be lost with its size.
  const bool shrinks = std::abs(factor) < 1 && std::abs(factor) > tolerance::vanishing_argument;
  const double s = 0.5 * (1 + (shrinks ? 1 / factor : factor));
  return {s, (shrinks ? 1 - s : s - 1) * flat_point(center), {}};
}

std::optional<Generator> motor_logarithm(const Versor& motor) {
  auto parts = motor_parts(motor);
  if (!parts) return std::nullopt;
  if (parts->scalar < 0) *parts = {-parts->scalar, -parts->turn, -parts->dual_scalar, -parts->dual_turn};
  return logarithm(*parts);
}

std::optional<Versor> motor_between(const Circle& from, const Circle& to) {
  const auto a = coordinates(from), b = coordinates(to);
  if (!a || !b || !a->line || !b->line) return std::nullopt;
  // The ratio of the lines, -L2 L1, turns and slides twice as far as the motor.
  const auto ratio = motor_parts(
      compose({0, line_from(b->point, b->direction).dual, {}}, {0, -1.0 * line_from(a->point, a->direction).dual, {}}));
  if (!ratio) return std::nullopt;
  if (ratio->scalar < 0 && length(ratio->turn) <= tolerance::opposite_directions) {
    // Half a turn about the line half way between them, square to both; any square direction when they are one line.
    const Vector p = to_vector(a->point), q = to_vector(b->point);
    const Vector across = normalized(cross(a->direction, q - p));
    const Vector axis = across == Vector{} ? any_perpendicular(a->direction) : across;
    return screw_motor(line_from(to_point(0.5 * (p + q)), axis), pi, 0);
  }
  return exponential(0.5 * logarithm(*ratio));
}

}  // namespace dini

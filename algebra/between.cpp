#include "algebra/between.h"

#include <cmath>

#include "algebra/construct.h"
#include "algebra/elementary.h"
#include "algebra/extract.h"
#include "algebra/products.h"
#include "algebra/tolerance.h"
#include "algebra/versor.h"

namespace dini {

namespace {

constexpr double pi = 3.14159265358979311600;
constexpr double undecided = 1e-12;  ///< of the squared size of 1 + X, below which its square root has no direction
constexpr double small_square = 0.015625;
constexpr int most_roots = 64;
constexpr int terms = 12;

/// A grade-4 part v I times itself.
double square_of(const Sphere& quad) { return -scalar_product(quad, quad); }

/// s + Q, the even elements that commute with everything made of one bivector.
Versor scalar_and_quad(double scalar, double factor, const Sphere& quad) {
  return {scalar, {}, {factor * quad.no, factor * quad.e, factor * quad.ni}};
}

/// The square root of a rotor with X ~X = 1: (1 + X) over the root of its own square, 2 (mu + Q). Nothing where that
/// vanishes.
std::optional<Versor> root(const Versor& x) {
  const double mu = 1 + x.scalar, square = mu * mu - square_of(x.quad);
  if (!(square > undecided) || !std::isfinite(square)) return std::nullopt;
  const double size = std::sqrt(square);
  if (!(mu + size > 0)) return std::nullopt;
  const double beta = std::sqrt(0.5 * (mu + size));
  Versor sum = x;
  sum.scalar = mu;
  const double scale = 1 / (std::sqrt(2.0) * size);
  return compose(sum, scalar_and_quad(scale * beta, -0.5 * scale / beta, x.quad));
}

std::optional<Versor> normalized_rotor(const Versor& rotor) {
  if (!is_versor(rotor)) return std::nullopt;
  const double square = compose(rotor, reverse(rotor)).scalar;
  if (!(square > 0)) return std::nullopt;
  const double scale = (rotor.scalar < 0 ? -1 : 1) / std::sqrt(square);
  return Versor{scale * rotor.scalar,
                scale * rotor.bivector,
                {scale * rotor.quad.no, scale * rotor.quad.e, scale * rotor.quad.ni}};
}

/// Half a turn about an axis across a circle or line: it runs the other way then.
Versor reversal(const CircleCoordinates& circle) {
  const Vector across = any_perpendicular(circle.line ? circle.direction : circle.normal);
  return screw_motor(line_from(circle.line ? circle.point : circle.center, across), pi, 0);
}

}  // namespace

std::optional<Generator> rotor_logarithm(const Versor& rotor) {
  std::optional<Versor> y = normalized_rotor(rotor);
  double doublings = 1;
  // Z = tanh(B/2) = (Y - 1) / (Y + 1), of a root of the rotor so small that the series of artanh is short.
  for (int k = 0; y && k < most_roots; ++k, doublings *= 2, y = root(*y)) {
    const double mu = 1 + y->scalar, square = mu * mu - square_of(y->quad);
    if (!(square > undecided)) return std::nullopt;
    const Versor z = compose({0, y->bivector, {}}, scalar_and_quad(mu / square, -1 / square, y->quad));
    const Versor zz = compose({0, z.bivector, {}}, {0, z.bivector, {}});
    if (!(std::abs(zz.scalar) + std::sqrt(std::abs(square_of(zz.quad))) < small_square)) continue;
    Versor sum{1.0 / (2 * terms + 1), {}, {}};
    for (int n = terms - 1; n >= 0; --n) {
      sum = compose(sum, {zz.scalar, {}, zz.quad});
      sum.scalar += 1.0 / (2 * n + 1);
    }
    return (2 * doublings) * compose(sum, {0, z.bivector, {}}).bivector;
  }
  return std::nullopt;
}

std::optional<Generator> similarity_between(const Circle& from, const Circle& to) {
  const auto a = coordinates(from), b = coordinates(to);
  if (!a || !b || a->line != b->line) return std::nullopt;
  if (a->line) {
    const auto motor = motor_between(from, to);
    return motor ? motor_logarithm(*motor) : std::nullopt;
  }
  if (a->radius == 0 || b->radius == 0) return std::nullopt;
  const Vector cross_product = cross(a->normal, b->normal);
  const double sine = length(cross_product), cosine = dot(a->normal, b->normal);
  const bool opposite = cosine < 0 && sine <= tolerance::opposite_directions;
  const Vector axis = opposite ? any_perpendicular(a->normal) : normalized(cross_product);
  const double angle = opposite ? pi : elementary::atan2(sine, cosine);
  const double ratio = b->radius / a->radius, logarithm = elementary::log(ratio);
  // x goes to ratio * turned x + shift, and with z = logarithm + i angle across the axis (logarithm along it) the
  // generator moves the origin by the part z / (e^z - 1) of the shift.
  const Vector center = to_vector(a->center);
  const auto [turn_sine, turn_cosine] = elementary::sincos(angle);
  const Vector turned =
      turn_cosine * center + turn_sine * cross(axis, center) + (1 - turn_cosine) * dot(axis, center) * axis;
  const Vector shift = to_vector(b->center) - ratio * turned;
  const double growth = 2 * elementary::exp(0.5 * logarithm) * elementary::sinh(0.5 * logarithm);
  const double half_sine = elementary::sin(0.5 * angle);
  const double real = growth * turn_cosine - 2 * half_sine * half_sine, imaginary = (1 + growth) * turn_sine;
  const double size = real * real + imaginary * imaginary;
  const double across_real = size > 0 ? (logarithm * real + angle * imaginary) / size : 1;
  const double across_imaginary = size > 0 ? (angle * real - logarithm * imaginary) / size : 0;
  const double along = growth != 0 ? logarithm / growth : 1;
  const Vector shift_along = dot(axis, shift) * axis, shift_across = shift - shift_along;
  const Vector moved = along * shift_along + across_real * shift_across + across_imaginary * cross(axis, shift_across);
  return Generator{{}, (-0.5 * angle) * axis, 0.5 * logarithm, -0.5 * moved};
}

std::optional<Generator> rotor_between(const Circle& from, const Circle& to) {
  const auto a = coordinates(from), b = coordinates(to);
  if (!a || !b) return std::nullopt;
  const auto p = unit_dual(*a), q = unit_dual(*b);
  if (!p || !q) return std::nullopt;
  const Versor ratio = compose({0, -1.0 * *q, {}}, {0, *p, {}});
  if (const auto rotor = root(ratio)) return rotor_logarithm(*rotor);
  const Versor other = compose({0, *q, {}}, {0, *p, {}});
  const auto rotor = root(other);
  return rotor ? rotor_logarithm(compose(*rotor, reversal(*a))) : std::nullopt;
}

std::optional<SphereRatio> sphere_ratio(const Sphere& from, const Sphere& to) {
  const double square = scalar_product(from, from) * scalar_product(to, to);
  if (!(scalar_product(from, from) > 0) || !(scalar_product(to, to) > 0)) return std::nullopt;
  // The nearer of the two orientations of the second sphere.
  const double sign = scalar_product(from, to) < 0 ? -1.0 : 1.0;
  const double scale = sign / std::sqrt(square);
  const double cosine = scale * scalar_product(from, to);
  const double squared_sine = cosine * cosine - 1;
  const double sine = std::sqrt(std::abs(squared_sine));
  double angle_per_sine = 1;
  if (sine > 1e-8) {
    angle_per_sine = (squared_sine < 0 ? elementary::atan2(sine, cosine) : elementary::asinh(sine)) / sine;
  }
  return SphereRatio{0.5 * angle_per_sine, scale * wedge(to, from)};
}

}  // namespace dini

#include "algebra/versor.h"

#include <cmath>

#include "algebra/frame.h"
#include "algebra/quaternion-inl.h"
#include "algebra/tolerance.h"

namespace dini {

namespace {

namespace lanes = HWY_NAMESPACE;
using Quaternion = lanes::Quaternion<double>;
using Matrix = lanes::Matrix<double>;

Matrix product(const Matrix& m, const Matrix& n) {
  return {m.a * n.a + m.b * n.c, m.a * n.b + m.b * n.d, m.c * n.a + m.d * n.c, m.c * n.b + m.d * n.d};
}

Quaternion conjugate(const Quaternion& q) { return {q.s, {-q.v.x, -q.v.y, -q.v.z}}; }

Matrix reversed(const Matrix& m) { return {conjugate(m.d), conjugate(m.b), conjugate(m.c), conjugate(m.a)}; }

/// The scalar part of V ~V.
double norm(const Matrix& m) { return (m.a * conjugate(m.d) + m.b * conjugate(m.c)).s; }

/// The matrix of the versor in coordinates whose origin is p.
Matrix seen_from(const Matrix& m, const Point& p) {
  const Quaternion shift{0, {-p.x, -p.y, -p.z}}, back{0, lanes::triple(p)};
  const Quaternion a = m.a + m.b * shift;
  const Quaternion c = m.c + m.d * shift;
  return {a, m.b, c + back * a, m.d + back * m.b};
}

/// V X ~V / <V ~V>, or V X ~V where that scalar is zero.
Versor sandwich(const Matrix& m, const Versor& element) {
  const double scale = norm(m);
  Versor result = lanes::versor(product(product(m, lanes::matrix(element)), reversed(m)));
  if (scale == 0 || !std::isfinite(scale)) return result;
  result.bivector = (1 / scale) * result.bivector;
  result.quad = {result.quad.no / scale, result.quad.e / scale, result.quad.ni / scale};
  return result;
}

/// vec(a ~c) / |a|^2: the image of the origin by the first column, of infinity by the second with (b, d).
std::optional<Vector> image(const Quaternion& weight, const Quaternion& rest, bool& infinite) {
  const double size = lanes::squared_size(weight);
  infinite = size == 0;
  if (infinite) {
    if (lanes::squared_size(rest) == 0) return std::nullopt;
    return Vector{};
  }
  return lanes::vector(lanes::vector_of_ratio(weight, rest)) / size;
}

}  // namespace

Vector middle(const Generator& g) {
  const double weight = squared_length(g.no_e);
  const double size = 2 * std::abs(dot(g.no_e, g.e_ni) - 0.5 * g.no_ni * g.no_ni + 0.5 * squared_length(g.e_e));
  if (!(weight > 0) || size >= squared_length(g.e_e) + g.no_ni * g.no_ni) return {};
  const Vector result = (g.no_ni * g.no_e + cross(g.no_e, g.e_e)) / weight;
  return is_finite(result) ? result : Vector{};
}

Generator seen_from(const Generator& generator, const Vector& origin) {
  return lanes::generator(lanes::seen_from(lanes::bivector(generator), lanes::triple(origin), 0.5));
}

Versor compose(const Versor& a, const Versor& b) { return lanes::versor(product(lanes::matrix(a), lanes::matrix(b))); }

Versor reverse(const Versor& versor) { return {versor.scalar, -1.0 * versor.bivector, versor.quad}; }

Versor versor_from(double scalar, const Generator& bivector) { return {scalar, bivector, {}}; }

std::optional<Point> apply(const Versor& versor, const Point& point) {
  const Matrix m = lanes::matrix(versor);
  const bool far =
      !(std::abs(point.x) <= tolerance::infinite_distance && std::abs(point.y) <= tolerance::infinite_distance &&
        std::abs(point.z) <= tolerance::infinite_distance);
  bool infinite = false;
  if (far) {
    const auto moved = image(m.b, m.d, infinite);
    if (!moved) return std::nullopt;
    return infinite || !is_finite(*moved) ? Point::at_infinity() : to_point(*moved);
  }
  const Quaternion shift{0, {-point.x, -point.y, -point.z}}, back{0, lanes::triple(point)};
  const Quaternion weight = m.a + m.b * shift, rest = m.c + m.d * shift;
  const auto moved = image(weight, rest + back * weight, infinite);
  if (!moved) return std::nullopt;
  Vector result = to_vector(point) + *moved;
  if (!infinite && squared_length(result) < tolerance::much_nearer * squared_length(to_vector(point))) {
    result = *image(weight, rest, infinite);
  }
  return infinite || !is_finite(result) ? Point::at_infinity() : to_point(result);
}

Generator apply(const Versor& versor, const Generator& generator) {
  const Vector origin = middle(generator);
  const Matrix m = lanes::matrix(versor);
  if (origin == Vector{}) return sandwich(m, {0, generator, {}}).bivector;
  const Versor moved = sandwich(seen_from(m, to_point(origin)), {0, seen_from(generator, origin), {}});
  return seen_from(moved.bivector, -origin);
}

Circle apply(const Versor& versor, const Circle& circle) { return {apply(versor, circle.dual)}; }

Sphere apply(const Versor& versor, const Sphere& sphere) {
  return sandwich(lanes::matrix(versor), {0, {}, sphere}).quad;
}

Vector apply_at(const Versor& versor, const Point& point, const Vector& direction) {
  if (!is_finite(point)) return {};
  const Matrix m = seen_from(lanes::matrix(versor), point);
  const double weight = lanes::squared_size(m.a);
  if (weight == 0) return {};
  // the quotient rule on vec(a ~c) / |a|^2 with da = -b v, dc = -d v
  const Quaternion step{0, lanes::triple(-direction)};
  const Quaternion da = m.b * step, dc = m.d * step;
  const Vector moved = lanes::vector(lanes::vector_of_ratio(m.a, m.c)) / weight;
  const Vector numerator =
      lanes::vector(lanes::vector_of_ratio(da, m.c)) + lanes::vector(lanes::vector_of_ratio(m.a, dc));
  const double weight_step = 2 * (da.s * m.a.s + dot(da.v, m.a.v));
  const Vector result = (numerator - weight_step * moved) / weight;
  return is_finite(result) ? result : Vector{};
}

bool has_inverse(const Versor& versor) {
  const Generator& g = versor.bivector;
  const double terms = versor.scalar * versor.scalar + squared_length(g.e_e) + g.no_ni * g.no_ni +
                       2 * std::abs(dot(g.no_e, g.e_ni)) + squared_length(versor.quad.e) +
                       2 * std::abs(versor.quad.no * versor.quad.ni);
  return std::abs(compose(versor, reverse(versor)).scalar) > tolerance::versor * terms;
}

bool is_versor(const Versor& versor) {
  const Versor square = compose(versor, reverse(versor));
  const Sphere& rest = square.quad;
  const Generator& g = versor.bivector;
  const double size = versor.scalar * versor.scalar + squared_length(g.no_e) + squared_length(g.e_e) +
                      g.no_ni * g.no_ni + squared_length(g.e_ni) + versor.quad.no * versor.quad.no +
                      squared_length(versor.quad.e) + versor.quad.ni * versor.quad.ni;
  const double noise = tolerance::versor * size;
  return std::isfinite(size) && std::abs(square.scalar) > noise && std::abs(rest.no) <= noise &&
         length(rest.e) <= noise && std::abs(rest.ni) <= noise;
}

}  // namespace dini

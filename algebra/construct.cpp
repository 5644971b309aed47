#include "algebra/construct.h"

#include <cmath>

#include "algebra/frame.h"
#include "algebra/tolerance.h"

namespace dini {

Generator null_pair(const Point& position, const Vector& tangent) {
  const Vector c = to_vector(position);
  const double slope = dot(c, tangent);
  return {tangent, cross(c, tangent), slope, slope * c - 0.5 * squared_length(c) * tangent};
}

Generator split_pair(const Point& position, const Vector& tangent, double split) {
  Generator result = null_pair(position, tangent);
  result.e_ni = result.e_ni - split * tangent;
  return result;
}

Generator flat_point(const Point& position) { return {{}, {}, 1, to_vector(position)}; }

Generator direction_generator(const Vector& direction) { return {{}, {}, 0, direction}; }

Generator rotation_generator(const Circle& axis) {
  const Generator& dual = axis.dual;
  // B.B = -r^2 |no_e|^2 for a circle and -|e_e|^2 for a line
  const double square = squared_length(dual.e_e) + 2 * dot(dual.no_e, dual.e_ni) - dual.no_ni * dual.no_ni;
  return square > 0 && std::isfinite(square) ? (1 / std::sqrt(square)) * dual : Generator{};
}

PointProduct point_product(const Point& a, double weight_a, const Point& b, double weight_b) {
  const Vector x = to_vector(a), y = to_vector(b);
  const double half_xx = 0.5 * squared_length(x), half_yy = 0.5 * squared_length(y);
  return {
      dot(x, y) - (weight_a * half_yy + weight_b * half_xx),
      {weight_a * y - weight_b * x, cross(x, y), weight_a * half_yy - weight_b * half_xx, half_yy * x - half_xx * y}};
}

Circle circle_from(const Point& center, const Vector& normal, double radius) {
  return {split_pair(center, normalized(normal), -0.5 * radius * radius)};
}

Circle line_from(const Point& point, const Vector& direction) {
  const Vector u = normalized(direction);
  return {{{}, u, 0, cross(to_vector(point), u)}};
}

Circle circle_through(const Point& a, const Point& b, const Point& c) {
  // The order is cyclic, so a point at infinity can always be the last.
  if (!is_finite(a)) return is_finite(b) && is_finite(c) ? line_from(b, to_vector(c) - to_vector(b)) : Circle{};
  if (!is_finite(b)) return is_finite(c) ? line_from(c, to_vector(a) - to_vector(c)) : Circle{};
  if (!is_finite(c)) return line_from(a, to_vector(b) - to_vector(a));
  const Vector u = to_vector(b) - to_vector(a), v = to_vector(c) - to_vector(a);
  const double uu = squared_length(u), vv = squared_length(v);
  if (uu == 0 || vv == 0 || u == v) return {};
  // Seen from a: no coefficient divides by the area, so nearly collinear points are as good as any.
  const Vector normal = cross(u, v);
  const Vector moment = 0.5 * (vv * u - uu * v);
  const double noise = tolerance::collinear * std::sqrt(uu) * std::sqrt(vv);
  if (length(normal) <= noise) return line_from(a, moment);
  return {seen_from({normal, moment, 0, {}}, -to_vector(a))};
}

Sphere sphere_from(const Point& center, double radius) {
  const Vector c = to_vector(center);
  return {1, c, 0.5 * (squared_length(c) - radius * radius)};
}

Sphere plane_from(const Point& point, const Vector& normal) {
  const Vector n = normalized(normal);
  return {0, n, dot(to_vector(point), n)};
}

}  // namespace dini

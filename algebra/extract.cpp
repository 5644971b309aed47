#include "algebra/extract.h"

#include <cmath>

#include "algebra/elementary.h"
#include "algebra/tolerance.h"

namespace dini {

std::optional<CircleCoordinates> coordinates(const Circle& circle) {
  const auto& [A, W, e, M] = circle.dual;
  const double weight = length(A), turn = length(W);
  if (!std::isfinite(weight + turn + std::abs(e)) || !is_finite(M)) return std::nullopt;
  CircleCoordinates result;
  if (weight <= tolerance::line_weight * (turn + std::abs(e))) {
    if (turn <= tolerance::line_weight * std::abs(e)) return std::nullopt;
    result.line = true;
    result.direction = normalized(W);
    result.point = to_point(cross(result.direction, M / turn));
    return result;
  }
  if (weight == 0) return std::nullopt;
  // Per unit of weight: W = c x n, e = c.n, M = e c - (c^2 - r^2)/2 n.
  const Vector n = normalized(A), w = W / weight, m = M / weight;
  const double height = e / weight;
  const double positive = squared_length(w), along = 2 * dot(n, m), negative = height * height;
  const double square = (positive - negative) + along;
  if (!(square >= -tolerance::square_radius_noise * (positive + negative + std::abs(along)))) return std::nullopt;
  result.normal = n;
  result.center = to_point(height * n + cross(n, w));
  result.radius = std::sqrt(square > 0 ? square : 0);
  return result;
}

std::optional<SphereCoordinates> coordinates(const Sphere& sphere) {
  const double size = length(sphere.e);
  if (!std::isfinite(size + sphere.no + sphere.ni)) return std::nullopt;
  SphereCoordinates result;
  if (std::abs(sphere.no) <= tolerance::plane_weight * size) {
    if (size == 0) return std::nullopt;
    result.plane = true;
    result.normal = normalized(sphere.e);
    result.distance = sphere.ni / size;
    return result;
  }
  if (sphere.no == 0) return std::nullopt;
  const Vector center = sphere.e / sphere.no;
  const double cc = squared_length(center), height = 2 * (sphere.ni / sphere.no);
  const double square = cc - height;
  if (!(square >= -tolerance::square_radius_noise * (cc + std::abs(height)))) return std::nullopt;
  result.center = to_point(center);
  result.radius = std::sqrt(square > 0 ? square : 0);
  return result;
}

Point point_at(const CircleCoordinates& circle, double turn, double length) {
  if (circle.line) return to_point(to_vector(circle.point) + (turn * length) * circle.direction);
  const Vector first = any_perpendicular(circle.normal);
  const Vector second = cross(circle.normal, first);
  const auto [sine, cosine] = elementary::sincos_turns(turn);
  return to_point(to_vector(circle.center) + circle.radius * (cosine * first + sine * second));
}

}  // namespace dini

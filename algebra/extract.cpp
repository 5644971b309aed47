#include "algebra/extract.h"

#include <cmath>

#include "algebra/elementary.h"
#include "algebra/tolerance.h"

namespace dini {

std::optional<CircleCoordinates> coordinates(const Circle& circle) {
  const auto& [A, W, e, M] = circle.dual;
  if (!std::isfinite(e) || !is_finite(A) || !is_finite(W) || !is_finite(M)) return std::nullopt;
  // -B.B = W^2 - e^2 + 2 A.M is |no_e|^2 r^2 for a circle and |e_e|^2 for a line.
  const double weight = length(A), turn = length(W);
  const double positive = turn * turn, along = 2 * dot(A, M), negative = e * e;
  const double square = (positive - negative) + along;
  const double noise = tolerance::square_radius_noise * (positive + negative + std::abs(along));
  if (!(square >= -noise)) return std::nullopt;
  const double size = std::sqrt(square > noise ? square : 0);
  CircleCoordinates result;
  if (size > 0 && weight <= tolerance::line_weight * size) {
    if (turn == 0) return std::nullopt;
    result.line = true;
    result.direction = normalized(W);
    result.point = to_point(cross(result.direction, M / turn));
    return result;
  }
  if (weight == 0) return std::nullopt;
  result.normal = normalized(A);
  // Per unit of weight W = c x n and e = c.n.
  result.center = to_point((e / weight) * result.normal + cross(result.normal, W / weight));
  result.radius = size / weight;
  return result;
}

std::optional<SphereCoordinates> coordinates(const Sphere& sphere) {
  const double size = length(sphere.e);
  if (!std::isfinite(size + sphere.no + sphere.ni)) return std::nullopt;
  SphereCoordinates result;
  // s.s = e^2 - 2 no ni is no^2 r^2 for a sphere and |e|^2 for a plane.
  const double height = 2 * sphere.no * sphere.ni;
  const double square = size * size - height;
  const double noise = tolerance::square_radius_noise * (size * size + std::abs(height));
  if (!(square >= -noise)) return std::nullopt;
  const double root = std::sqrt(square > noise ? square : 0);
  if (root > 0 && std::abs(sphere.no) <= tolerance::plane_weight * root) {
    result.plane = true;
    result.normal = normalized(sphere.e);
    result.distance = sphere.ni / size;
    return result;
  }
  if (sphere.no == 0) return std::nullopt;
  result.center = to_point(sphere.e / sphere.no);
  result.radius = root / std::abs(sphere.no);
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

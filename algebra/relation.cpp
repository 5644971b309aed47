#include "algebra/relation.h"

#include <algorithm>
#include <cmath>

#include "algebra/construct.h"
#include "algebra/extract.h"
#include "algebra/products.h"
#include "algebra/tolerance.h"

namespace dini {

namespace {

Vector across(const Vector& way, const Vector& unit) { return way - dot(way, unit) * unit; }

Point nearest_on(const CircleCoordinates& circle, const Point& to) {
  if (circle.line) {
    if (!is_finite(to)) return Point::at_infinity();
    const Vector p = to_vector(circle.point);
    return to_point(p + dot(to_vector(to) - p, circle.direction) * circle.direction);
  }
  if (!is_finite(to)) return point_at(circle, 0);
  const Vector center = to_vector(circle.center), way = to_vector(to) - center;
  const Vector flat = across(way, circle.normal);
  if (length(flat) <= tolerance::collinear * (length(way) + length(center))) return point_at(circle, 0);
  return to_point(center + circle.radius * normalized(flat));
}

/// The distance of a point that is not at infinity.
double distance_to(const CircleCoordinates& circle, const Vector& p) {
  if (circle.line) return length(across(p - to_vector(circle.point), circle.direction));
  const Vector way = p - to_vector(circle.center);
  const double height = dot(way, circle.normal);
  return length({length(way - height * circle.normal) - circle.radius, height, 0});
}

double distance_to(const SphereCoordinates& sphere, const Vector& p) {
  if (sphere.plane) return std::abs(dot(sphere.normal, p) - sphere.distance);
  return std::abs(length(p - to_vector(sphere.center)) - sphere.radius);
}

/// The least distance of the points of a circle from another: from each local minimum among samples by golden section.
double searched_distance(const CircleCoordinates& circle, const CircleCoordinates& other) {
  constexpr int samples = 256, sections = 48;
  constexpr double golden = 0.61803398874989484820;
  const auto at = [&](double turn) { return distance_to(other, to_vector(point_at(circle, turn))); };
  double found[samples];
  for (int i = 0; i < samples; ++i) found[i] = at(static_cast<double>(i) / samples);
  double least = *std::min_element(found, found + samples);
  for (int i = 0; i < samples; ++i) {
    const double before = found[(i + samples - 1) % samples], after = found[(i + 1) % samples];
    if (found[i] > before || found[i] >= after) continue;
    double low = (i - 1.0) / samples, high = (i + 1.0) / samples;
    double left = high - golden * (high - low), right = low + golden * (high - low);
    double at_left = at(left), at_right = at(right);
    for (int k = 0; k < sections; ++k) {
      if (at_left < at_right) {
        high = right;
        right = left;
        at_right = at_left;
        left = high - golden * (high - low);
        at_left = at(left);
      } else {
        low = left;
        left = right;
        at_left = at_right;
        right = low + golden * (high - low);
        at_right = at(right);
      }
    }
    least = std::min({least, at_left, at_right});
  }
  return least;
}

double distance_of_lines(const CircleCoordinates& a, const CircleCoordinates& b) {
  const Vector way = to_vector(b.point) - to_vector(a.point), normal = cross(a.direction, b.direction);
  if (length(normal) <= tolerance::opposite_directions) return length(across(way, a.direction));
  return std::abs(dot(way, normalized(normal)));
}

Vector place_of(const CircleCoordinates& circle) { return to_vector(circle.line ? circle.point : circle.center); }

}  // namespace

std::optional<Point> nearest_point(const Circle& circle, const Point& to) {
  const auto found = coordinates(circle);
  if (!found) return std::nullopt;
  return nearest_on(*found, to);
}

std::optional<Point> nearest_point(const Sphere& sphere, const Point& to) {
  const auto found = coordinates(sphere);
  if (!found) return std::nullopt;
  if (found->plane) {
    if (!is_finite(to)) return Point::at_infinity();
    const Vector p = to_vector(to);
    return to_point(p - (dot(found->normal, p) - found->distance) * found->normal);
  }
  const Vector center = to_vector(found->center);
  const Vector outward = is_finite(to) ? normalized(to_vector(to) - center) : Vector{};
  return to_point(center + found->radius * (outward == Vector{} ? Vector{0, 0, 1} : outward));
}

std::optional<double> least_distance(const Point& a, const Point& b) {
  if (!is_finite(a) || !is_finite(b)) return std::nullopt;
  return length(to_vector(b) - to_vector(a));
}

std::optional<double> least_distance(const Circle& a, const Point& b) {
  const auto found = coordinates(a);
  if (!found) return std::nullopt;
  if (!is_finite(b)) return found->line ? std::optional(0.0) : std::nullopt;
  return distance_to(*found, to_vector(b));
}

std::optional<double> least_distance(const Sphere& a, const Point& b) {
  const auto found = coordinates(a);
  if (!found) return std::nullopt;
  if (!is_finite(b)) return found->plane ? std::optional(0.0) : std::nullopt;
  return distance_to(*found, to_vector(b));
}

std::optional<double> least_distance(const Circle& a, const Circle& b) {
  const auto first = coordinates(a), second = coordinates(b);
  if (!first || !second) return std::nullopt;
  if (first->line && second->line) return distance_of_lines(*first, *second);
  // The smaller circle is walked along: its points lie denser.
  const bool walk_second = first->line || (!second->line && second->radius < first->radius);
  return walk_second ? searched_distance(*second, *first) : searched_distance(*first, *second);
}

std::optional<double> least_distance(const Circle& a, const Sphere& b) {
  const auto circle = coordinates(a);
  const auto sphere = coordinates(b);
  if (!circle || !sphere) return std::nullopt;
  if (sphere->plane) {
    const double height = dot(sphere->normal, place_of(*circle)) - sphere->distance;
    if (circle->line) {
      const bool parallel = std::abs(dot(sphere->normal, circle->direction)) <= tolerance::collinear;
      return parallel ? std::abs(height) : 0;
    }
    // As high above its center as the circle reaches.
    const double reach = circle->radius * length(across(sphere->normal, circle->normal));
    return std::max(std::abs(height) - reach, 0.0);
  }
  // From its nearest to its farthest point from the center.
  const Vector center = to_vector(sphere->center);
  const double nearest = distance_to(*circle, center);
  if (circle->line) return std::max(nearest - sphere->radius, 0.0);
  const Vector way = center - to_vector(circle->center);
  const double height = dot(way, circle->normal);
  const double farthest = length({length(way - height * circle->normal) + circle->radius, height, 0});
  return std::max({nearest - sphere->radius, sphere->radius - farthest, 0.0});
}

std::optional<double> least_distance(const Sphere& a, const Sphere& b) {
  const auto first = coordinates(a), second = coordinates(b);
  if (!first || !second) return std::nullopt;
  if (first->plane && second->plane) {
    if (length(cross(first->normal, second->normal)) > tolerance::collinear) return 0;
    const double sense = dot(first->normal, second->normal) < 0 ? -1 : 1;
    return std::abs(first->distance - sense * second->distance);
  }
  if (first->plane || second->plane) {
    const SphereCoordinates &plane = first->plane ? *first : *second, &sphere = first->plane ? *second : *first;
    return std::max(distance_to(plane, to_vector(sphere.center)) - sphere.radius, 0.0);
  }
  const double apart = length(to_vector(second->center) - to_vector(first->center));
  return std::max({apart - (first->radius + second->radius), std::abs(first->radius - second->radius) - apart, 0.0});
}

std::optional<double> angle_cosine(const Circle& a, const Circle& b) {
  const auto first = coordinates(a), second = coordinates(b);
  if (!first || !second) return std::nullopt;
  const Vector origin = place_of(*first);
  const auto p = unit_dual(*first, origin), q = unit_dual(*second, origin);
  if (!p || !q) return std::nullopt;
  return dot(p->e_e, q->e_e) + dot(p->no_e, q->e_ni) + dot(p->e_ni, q->no_e) - p->no_ni * q->no_ni;
}

std::optional<double> angle_cosine(const Circle& a, const Sphere& b) {
  const auto circle = coordinates(a);
  const auto sphere = coordinates(b);
  if (!circle || !sphere || (!sphere->plane && sphere->radius == 0)) return std::nullopt;
  const Vector origin = place_of(*circle);
  const auto dual = unit_dual(*circle, origin);
  if (!dual) return std::nullopt;
  const Vector center = to_vector(sphere->center) - origin;
  const double r = sphere->radius;
  const Sphere s = sphere->plane ? Sphere{0, sphere->normal, sphere->distance - dot(sphere->normal, origin)}
                                 : Sphere{1 / r, center / r, 0.5 * (squared_length(center) - r * r) / r};
  // s . B lies in the plane of B: it is as long as the part of s there.
  const Sphere part = contraction(s, *dual);
  return std::sqrt(std::max(squared_length(part.e) - 2 * part.no * part.ni, 0.0));
}

std::optional<double> angle_cosine(const Sphere& a, const Sphere& b) {
  const auto first = coordinates(a), second = coordinates(b);
  if (!first || !second) return std::nullopt;
  if (first->plane && second->plane) return dot(first->normal, second->normal);
  if ((!first->plane && first->radius == 0) || (!second->plane && second->radius == 0)) return std::nullopt;
  if (first->plane || second->plane) {
    const SphereCoordinates &plane = first->plane ? *first : *second, &sphere = first->plane ? *second : *first;
    return (dot(plane.normal, to_vector(sphere.center)) - plane.distance) / sphere.radius;
  }
  const double r = first->radius, s = second->radius;
  const double apart = length(to_vector(second->center) - to_vector(first->center));
  return ((r - apart) * (r + apart) / s + s) / (2 * r);
}

}  // namespace dini

#include "algebra/meet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algebra/construct.h"
#include "algebra/extract.h"
#include "algebra/tolerance.h"

namespace dini {

namespace {

constexpr double noise = tolerance::square_radius_noise;

Meeting kind_of_gap(double gap, double terms) {
  if (std::abs(gap) <= noise * terms) return Meeting::touching;
  return gap > 0 ? Meeting::crossing : Meeting::apart;
}

double size_of(const Point& p) { return length(to_vector(p)); }

/// The circle about `normal` with this center and square of the radius; without one where that is not above zero.
SphereMeeting round_meeting(Meeting kind, const Vector& center, const Vector& normal, double square) {
  const double radius = kind == Meeting::crossing ? std::sqrt(std::max(square, 0.0)) : 0.0;
  const CircleCoordinates circle{false, to_point(center), normal, radius, {}, {}};
  SphereMeeting meeting{kind, circle_from(circle.center, normal, radius)};
  if (kind == Meeting::apart) return meeting;
  meeting.a = point_at(circle, 0);
  meeting.b = point_at(circle, 0.5);
  return meeting;
}

std::optional<SphereMeeting> meet_of_spheres(const SphereCoordinates& first, const SphereCoordinates& second) {
  const Vector from = to_vector(first.center), way = to_vector(second.center) - from;
  const double r = first.radius, s = second.radius, distance = length(way);
  const double terms = distance + r + s + size_of(first.center) + size_of(second.center);
  if (distance <= noise * terms) {
    if (std::abs(r - s) <= noise * terms) return std::nullopt;
    return round_meeting(Meeting::apart, from, {0, 0, 1}, 0);
  }
  const Vector normal = way / distance;
  const double outside = r + s - distance, inside = distance - std::abs(r - s);
  const Meeting kind = kind_of_gap(std::min(outside, inside), terms);
  if (kind == Meeting::touching) {
    const double along = inside < outside && s > r ? -r : r;
    return round_meeting(kind, from + along * normal, normal, 0);
  }
  const double along = 0.5 * (distance + (r + s) / distance * (r - s));
  const double square =
      outside * inside / (2 * distance) * ((r + s + distance) * (distance + std::abs(r - s))) / (2 * distance);
  return round_meeting(kind, from + along * normal, normal, square);
}

SphereMeeting meet_of_sphere_and_plane(const SphereCoordinates& sphere, const SphereCoordinates& plane,
                                       const Vector& normal) {
  const double height = dot(plane.normal, to_vector(sphere.center)) - plane.distance, r = sphere.radius;
  const Vector center = to_vector(sphere.center) - height * plane.normal;
  const double gap = r - std::abs(height);
  const double terms = r + std::abs(height) + size_of(sphere.center) + std::abs(plane.distance);
  return round_meeting(kind_of_gap(gap, terms), center, normal, gap * (r + std::abs(height)));
}

std::optional<SphereMeeting> meet_of_planes(const SphereCoordinates& first, const SphereCoordinates& second) {
  const Vector along = cross(first.normal, second.normal);
  const double square = squared_length(along);
  if (std::sqrt(square) <= tolerance::collinear) {
    const double sense = dot(first.normal, second.normal);
    const double gap = std::abs(first.distance - sense * second.distance);
    if (gap <= noise * (std::abs(first.distance) + std::abs(second.distance))) return std::nullopt;
    const Vector between = 0.5 * (first.distance + sense * second.distance) * first.normal;
    return SphereMeeting{Meeting::touching, circle_from(to_point(between), first.normal, 0)};
  }
  const Vector place =
      (first.distance * cross(second.normal, along) + second.distance * cross(along, first.normal)) / square;
  const Circle line = line_from(to_point(place), along);
  return SphereMeeting{Meeting::crossing, line, to_point(place)};
}

/// A pair about `foot` along a unit `direction`, half its length squared being `square`.
CircleMeeting pair_meeting(Meeting kind, const Vector& foot, const Vector& direction, double square) {
  CircleMeeting meeting{kind, split_pair(to_point(foot), direction, kind == Meeting::touching ? 0.0 : 0.5 * square)};
  if (kind == Meeting::apart) return meeting;
  const double half = kind == Meeting::crossing ? std::sqrt(std::max(square, 0.0)) : 0.0;
  meeting.a = to_point(foot + half * direction);
  meeting.b = to_point(foot - half * direction);
  return meeting;
}

std::optional<CircleMeeting> meet_of_line(const CircleCoordinates& line, const SphereCoordinates& sphere) {
  const Vector p = to_vector(line.point), u = line.direction;
  if (!sphere.plane) {
    const Vector way = to_vector(sphere.center) - p;
    const double along = dot(way, u), across = length(way - along * u), r = sphere.radius;
    const Meeting kind = kind_of_gap(r - across, r + across + size_of(line.point) + size_of(sphere.center));
    return pair_meeting(kind, p + along * u, u, (r - across) * (r + across));
  }
  const double slope = dot(sphere.normal, u), gap = sphere.distance - dot(sphere.normal, p);
  if (std::abs(slope) <= tolerance::collinear) {
    if (std::abs(gap) <= noise * (std::abs(sphere.distance) + length(p))) return std::nullopt;
    return CircleMeeting{Meeting::touching, direction_generator(u)};
  }
  const Point place = to_point(p + (gap / slope) * u);
  return CircleMeeting{Meeting::crossing, flat_point(place), place};
}

/// The function of the sphere over the circle of radius R is q . y - height, q the part of its slope at the center in
/// the plane of the circle: both meet on the line across q at height / |q| from the center.
std::optional<CircleMeeting> meet_of_round(const CircleCoordinates& circle, const SphereCoordinates& sphere) {
  const Vector o = to_vector(circle.center);
  const double R = circle.radius;
  const Vector slope = sphere.plane ? sphere.normal : to_vector(sphere.center) - o;
  const double height = sphere.plane ? sphere.distance - dot(sphere.normal, o)
                                     : 0.5 * ((R - sphere.radius) * (R + sphere.radius) + squared_length(slope));
  const double terms = sphere.plane ? std::abs(sphere.distance) + length(o)
                                    : R * R + sphere.radius * sphere.radius + squared_length(slope) +
                                          length(slope) * (length(o) + size_of(sphere.center));
  const Vector q = slope - dot(slope, circle.normal) * circle.normal;
  const double steepness = length(q);
  const double steepness_noise =
      tolerance::collinear * (sphere.plane ? 1.0 : length(slope) + length(o) + size_of(sphere.center));
  if (steepness <= steepness_noise) {
    if (std::abs(height) <= noise * terms + steepness * R) {
      if (R == 0) return pair_meeting(Meeting::touching, o, any_perpendicular(circle.normal), 0);
      return std::nullopt;
    }
    return CircleMeeting{Meeting::apart, rotation_generator(line_from(circle.center, circle.normal))};
  }
  const double away = height / steepness;
  const Meeting kind = kind_of_gap(R - std::abs(away), R + terms / steepness + length(o));
  const Vector outward = q / steepness;
  const double foot = kind == Meeting::touching ? std::copysign(R, away) : away;
  return pair_meeting(kind, o + foot * outward, cross(circle.normal, outward),
                      (R - std::abs(away)) * (R + std::abs(away)));
}

}  // namespace

std::optional<SphereMeeting> meet(const Sphere& first, const Sphere& second) {
  const auto a = coordinates(first), b = coordinates(second);
  if (!a || !b) return std::nullopt;
  if (a->plane && b->plane) return meet_of_planes(*a, *b);
  if (b->plane) return meet_of_sphere_and_plane(*a, *b, b->normal);
  if (a->plane) return meet_of_sphere_and_plane(*b, *a, -a->normal);
  return meet_of_spheres(*a, *b);
}

std::optional<CircleMeeting> meet(const Circle& circle, const Sphere& sphere) {
  const auto a = coordinates(circle);
  const auto b = coordinates(sphere);
  if (!a || !b) return std::nullopt;
  return a->line ? meet_of_line(*a, *b) : meet_of_round(*a, *b);
}

std::optional<Sphere> sphere_through(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<Point, 4> points{a, b, c, d};
  // One at infinity goes to the end, and those that are left stay in their order.
  const auto is_far = [](const Point& p) { return !is_finite(p); };
  if (std::count_if(points.begin(), points.end(), is_far) > 1) return std::nullopt;
  if (is_far(points[0])) points = {b, c, d, a};
  if (is_far(points[1])) points = {a, c, d, b};
  if (is_far(points[2])) points = {a, b, d, c};
  const Vector origin = to_vector(points[0]);
  const Vector u = to_vector(points[1]) - origin, v = to_vector(points[2]) - origin;
  const Vector normal = cross(u, v);
  const double uu = squared_length(u), vv = squared_length(v);
  const bool straight = length(normal) <= tolerance::collinear * std::sqrt(uu) * std::sqrt(vv);
  if (is_far(points[3])) return straight ? std::nullopt : std::optional(plane_from(points[0], normal));
  const Vector w = to_vector(points[3]) - origin;
  const double ww = squared_length(w);
  const double scale = std::sqrt(uu) * std::sqrt(vv) * std::sqrt(ww);
  if (scale == 0 || u == v || v == w || w == u) return std::nullopt;
  // The center is toward / volume from the first point; a vanishing volume leaves the plane's normal.
  const double volume = 2 * dot(normal, w);
  const Vector toward = uu * cross(v, w) + vv * cross(w, u) + ww * normal;
  const double largest = std::sqrt(std::max({uu, vv, ww}));
  const bool flat = std::abs(volume) <= noise * scale;
  if (flat && length(toward) <= noise * scale * largest) return std::nullopt;
  if (flat) return plane_from(points[0], dot(toward, normal) < 0 ? -toward : toward);
  const Vector center = toward / volume;
  if (!is_finite(center)) return std::nullopt;
  return sphere_from(to_point(origin + center), length(center));
}

}  // namespace dini

#include "algebra/reflection.h"

#include <cmath>

#include "algebra/extract.h"
#include "algebra/frame.h"
#include "algebra/products.h"
#include "algebra/tolerance.h"

namespace dini {

namespace {

double square(const Sphere& s) { return squared_length(s.e) - 2 * s.no * s.ni; }

/// The same sphere in coordinates whose origin is `origin`.
Sphere seen_from(const Sphere& s, const Vector& origin) {
  return {s.no, s.e - s.no * origin, s.ni - dot(s.e, origin) + 0.5 * s.no * squared_length(origin)};
}

/// Half of the slope of the mirror's function s.P at p. Twice the function over it is the way to the image.
Vector slope(const Sphere& mirror, const Vector& p) { return mirror.e - mirror.no * p; }

}  // namespace

bool is_mirror(const Sphere& mirror) {
  const auto found = coordinates(mirror);
  return found && (found->plane || found->radius > 0);
}

Point reflect(const Sphere& mirror, const Point& point) {
  const Vector center = mirror.e / mirror.no;  // infinite for a plane
  if (!is_finite(point)) return is_finite(center) ? to_point(center) : Point::at_infinity();
  const Vector p = to_vector(point), up = slope(mirror, p);
  const double steepness = squared_length(up);
  const double size = square(mirror);
  // From a few radii on, the image is nearer to the center than to the point, and has its digits from there.
  const bool afar = mirror.no != 0 && steepness > 4 * size;
  const Vector image =
      afar ? center - (size / mirror.no / steepness) * up
           : p - (2 * (dot(mirror.e, p) - 0.5 * mirror.no * squared_length(p) - mirror.ni) / steepness) * up;
  return is_finite(image) ? to_point(image) : Point::at_infinity();
}

Generator reflect(const Sphere& mirror, const Generator& generator) {
  const Vector origin = middle(generator);
  const Sphere s = seen_from(mirror, origin);
  const Generator local = seen_from(generator, origin);
  const Generator reflected = local + (-2 / square(s)) * wedge(s, contraction(s, local));
  return seen_from(reflected, -origin);
}

Circle reflect(const Sphere& mirror, const Circle& circle) { return {-1.0 * reflect(mirror, circle.dual)}; }

Sphere reflect(const Sphere& mirror, const Sphere& sphere) {
  // From its own center, when that is far beside the radius.
  const Vector center = sphere.e / sphere.no;
  const Vector origin = 4 * square(sphere) < squared_length(sphere.e) && is_finite(center) ? center : Vector{};
  const Sphere s = seen_from(mirror, origin), local = seen_from(sphere, origin);
  const double factor = 2 * (dot(s.e, local.e) - s.no * local.ni - s.ni * local.no) / square(s);
  return seen_from({local.no - factor * s.no, local.e - factor * s.e, local.ni - factor * s.ni}, -origin);
}

Vector reflect_at(const Sphere& mirror, const Point& point, const Vector& direction) {
  if (!is_finite(point)) return {};
  const Vector up = normalized(slope(mirror, to_vector(point)));
  return up == Vector{} ? up : direction - (2 * dot(up, direction)) * up;
}

}  // namespace dini

#include "geometry/dome.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"

namespace dini {

namespace {

constexpr double steepest_apex = 4;          ///< height of an apex in radii
constexpr double widest_angle = 5 * pi / 6;  ///< between a tangent and the way to the apex

/// Twice the area of a loop, along its normal.
Vector area_of(const std::vector<Vector>& places) {
  Vector sum;
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    sum = sum + cross(places[i] - places[0], places[i + 1] - places[0]);
  }
  return sum;
}

/// The place at `share` of the circle from `from`, which it leaves along `tangent`, to `to`.
Vector place_on_arc(const Vector& from, const Vector& tangent, const Vector& to, double share) {
  const Vector chord = to - from;
  const double span = length(chord);
  const double angle = std::min(angle_between(tangent, chord), widest_angle);
  if (!(angle > 1e-7) || share >= 1) return from + share * chord;
  const Vector straight = chord / span;
  const Vector aside = normalized(tangent - dot(tangent, straight) * straight);
  // The chords from the first place turn evenly from the tangent to the whole chord (inscribed angles).
  const SineCosine whole = sine_cosine(angle / (2 * pi)), left = sine_cosine((1 - share) * angle / (2 * pi)),
                   gone = sine_cosine(share * angle / (2 * pi));
  return from + (span * gone.sine / whole.sine) * (left.cosine * straight + left.sine * aside);
}

}  // namespace

DomeShape dome_shape(const Rim& rim) {
  const std::size_t count = rim.places.size();
  DomeShape shape;
  double around = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector &p = rim.places[i], &q = rim.places[(i + 1) % count];
    const double step = length(q - p);
    shape.middle = shape.middle + (0.5 * step) * (p + q);
    around += step;
  }
  shape.middle = around > 0 ? shape.middle / around : rim.places.front();
  shape.normal = normalized(area_of(rim.places));
  double radius = 0, upward = 0, inward = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double step = 0.5 * (length(rim.places[(i + 1) % count] - rim.places[i]) +
                               length(rim.places[i] - rim.places[(i + count - 1) % count]));
    const Vector out = rim.places[i] - shape.middle;
    const Vector flat = out - dot(out, shape.normal) * shape.normal;
    radius += step * length(flat);
    upward += step * dot(rim.tangents[i], shape.normal);
    inward -= step * dot(rim.tangents[i], normalized(flat));
  }
  // On a sphere the tangent and the way inward enclose twice the angle under which the apex is seen.
  const double enough = std::sqrt(upward * upward + inward * inward) + inward;
  const double slope = std::abs(upward) < steepest_apex * enough ? upward / enough
                       : upward == 0                             ? 0
                                                                 : std::copysign(steepest_apex, upward);
  shape.apex = shape.middle + (around > 0 ? slope * radius / around : 0) * shape.normal;
  return shape;
}

std::vector<Vector> dome_ring(const Rim& rim, const Vector& apex, double share) {
  std::vector<Vector> ring(rim.places.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    ring[i] = place_on_arc(rim.places[i], rim.tangents[i], apex, share);
  }
  return ring;
}

}  // namespace dini

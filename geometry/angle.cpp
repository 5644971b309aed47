#include "geometry/angle.h"

namespace dini {

SineCosine sine_cosine(double turns) {
  const double part = turns - std::floor(turns);
  const double quarter = std::floor(4 * part + 0.5);
  const double x = 2 * pi * (part - quarter / 4);  // |x| <= pi/4
  const double y = x * x;
  // Taylor series; the first terms left out are x^17/17! and x^18/18!, below 5e-17.
  double sine = 0;
  for (int k = 15; k > 1; k -= 2) sine = (1 - sine) * y / (k * (k - 1));
  sine = x * (1 - sine);
  double cosine = 0;
  for (int k = 16; k > 0; k -= 2) cosine = (1 - cosine) * y / (k * (k - 1));
  cosine = 1 - cosine;
  switch (static_cast<int>(quarter) & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

double angle_of(double x, double y) {
  if (y == 0) return x < 0 ? pi : 0;
  if (x < 0) return pi - angle_of(-x, y);
  // Three half-angle steps bring the tangent below tan(pi/16), where the series is short.
  double tangent = y / (x + std::sqrt(x * x + y * y));
  tangent /= 1 + std::sqrt(1 + tangent * tangent);
  tangent /= 1 + std::sqrt(1 + tangent * tangent);
  const double square = tangent * tangent;
  double sum = 0;
  for (int k = 23; k >= 1; k -= 2) sum = 1.0 / k - square * sum;
  return 8 * tangent * sum;
}

double angle_between(const Vector& a, const Vector& b) {
  const Vector u = normalized(a);
  const Vector v = normalized(b);
  return angle_of(dot(u, v), length(cross(u, v)));
}

}  // namespace dini

// Signs of determinants, by expansions: sums of doubles that do not overlap, in ascending magnitude, which hold every
// bit (Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates, 1997). Zeros are
// left out, so numbers on a grid stay short.

#include "geometry/exact_sign.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace dini {

namespace {

/// An exact sum of at most `most` terms.
template <std::size_t most>
struct Expansion {
  std::array<double, most> terms;
  std::size_t size = 0;

  void add(double number) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size; ++i) {
      // Knuth's sum of two numbers, and what it rounds off.
      const double sum = number + terms[i], virtual_part = sum - number;
      const double lost = (number - (sum - virtual_part)) + (terms[i] - virtual_part);
      if (lost != 0) terms[kept++] = lost;
      number = sum;
    }
    if (number != 0) terms[kept++] = number;
    size = kept;
  }

  /// The largest term is last, and outweighs the others.
  int sign() const { return size == 0 ? 0 : terms[size - 1] > 0 ? 1 : -1; }
};

struct Halves {
  double high, low;
};

/// Dekker's split into two numbers of 26 bits.
Halves halves(double number) {
  const double large = 134217729.0 * number;  // 2^27 + 1
  const double high = large - (large - number);
  return {high, number - high};
}

template <std::size_t most>
void add_exact_product(Expansion<most>& sum, double a, double b) {
  const double product = a * b;
  const auto [a_high, a_low] = halves(a);
  const auto [b_high, b_low] = halves(b);
  const double lost = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
  sum.add(lost);
  sum.add(product);
}

template <std::size_t most, std::size_t left, std::size_t right>
void add_exact_product(Expansion<most>& sum, const Expansion<left>& a, const Expansion<right>& b, double sign) {
  for (std::size_t i = 0; i < a.size; ++i) {
    for (std::size_t k = 0; k < b.size; ++k) add_exact_product(sum, sign * a.terms[i], b.terms[k]);
  }
}

using ExactDifference = Expansion<2>;
using ExactMinor = Expansion<16>;
using ExactDeterminant = Expansion<192>;

ExactDifference exact_difference(double a, double b) {
  ExactDifference result;
  result.add(a);
  result.add(-b);
  return result;
}

struct ExactVector {
  ExactDifference x, y, z;
};

ExactVector exact_difference(const Vector& a, const Vector& b) {
  return {exact_difference(a.x, b.x), exact_difference(a.y, b.y), exact_difference(a.z, b.z)};
}

ExactMinor minor_of(const ExactDifference& a, const ExactDifference& b, const ExactDifference& c,
                    const ExactDifference& d) {
  ExactMinor result;
  add_exact_product(result, a, d, 1);
  add_exact_product(result, b, c, -1);
  return result;
}

/// The share of the sum of magnitudes that rounding can make of a determinant: well above what Shewchuk proves for
/// three rows (7 units in the last place), and that for two.
constexpr double uncertain = 2e-15;

}  // namespace

int side_of_plane(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  const Vector u = a - d, v = b - d, w = c - d;
  const double vw_x = v.y * w.z - v.z * w.y, vw_y = v.z * w.x - v.x * w.z, vw_z = v.x * w.y - v.y * w.x;
  const double value = u.x * vw_x + u.y * vw_y + u.z * vw_z;
  const double size = std::abs(u.x) * (std::abs(v.y * w.z) + std::abs(v.z * w.y)) +
                      std::abs(u.y) * (std::abs(v.z * w.x) + std::abs(v.x * w.z)) +
                      std::abs(u.z) * (std::abs(v.x * w.y) + std::abs(v.y * w.x));
  // The determinant of a, b, c seen from d is below zero where d is in front.
  if (std::abs(value) > uncertain * size) return value > 0 ? -1 : 1;
  const ExactVector exact_u = exact_difference(a, d), exact_v = exact_difference(b, d),
                    exact_w = exact_difference(c, d);
  ExactDeterminant sum;
  add_exact_product(sum, exact_u.x, minor_of(exact_v.y, exact_v.z, exact_w.y, exact_w.z), 1);
  add_exact_product(sum, exact_u.y, minor_of(exact_v.z, exact_v.x, exact_w.z, exact_w.x), 1);
  add_exact_product(sum, exact_u.z, minor_of(exact_v.x, exact_v.y, exact_w.x, exact_w.y), 1);
  return -sum.sign();
}

int turn_seen_along(int axis, const Vector& a, const Vector& b, const Vector& c) {
  const auto across = [axis](const Vector& v) { return axis == 0 ? v.y : axis == 1 ? v.z : v.x; };
  const auto along = [axis](const Vector& v) { return axis == 0 ? v.z : axis == 1 ? v.x : v.y; };
  const double left = (across(a) - across(c)) * (along(b) - along(c));
  const double right = (along(a) - along(c)) * (across(b) - across(c));
  const double value = left - right;
  if (std::abs(value) > uncertain * (std::abs(left) + std::abs(right))) return value > 0 ? 1 : -1;
  return minor_of(exact_difference(across(a), across(c)), exact_difference(along(a), along(c)),
                  exact_difference(across(b), across(c)), exact_difference(along(b), along(c)))
      .sign();
}

}  // namespace dini

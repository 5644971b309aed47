#include "algebra/generator_kind.h"

#include <algorithm>
#include <cmath>

#include "algebra/frame.h"
#include "algebra/versor.h"
#include "algebra/warp_source.h"

namespace dini {

namespace {

constexpr double smallest_split = 1e-6;  ///< of the squares, below which the parts cannot be told apart
constexpr double nudge = 1e-4;
constexpr double remainder = 1e-10;  ///< of a coefficient that the parts share; what is less is round-off

/// Whether B^B is zero beside the products that it is the sum of.
bool is_simple(const Generator& b, double noise) {
  const double tangent = length(b.no_e), turn = length(b.e_e), slope = std::abs(b.no_ni), shift = length(b.e_ni);
  const Vector middle = b.no_ni * b.e_e + cross(b.no_e, b.e_ni);
  return std::abs(dot(b.no_e, b.e_e)) <= noise * tangent * turn &&
         std::abs(dot(b.e_ni, b.e_e)) <= noise * shift * turn &&
         length(middle) <= noise * (slope * turn + tangent * shift);
}

GeneratorKind kind_of_pair(const Generator& b, double noise) {
  const double positive = b.no_ni * b.no_ni, negative = squared_length(b.e_e), along = 2 * dot(b.no_e, b.e_ni);
  const double square = positive - negative - along;
  if (std::abs(square) <= noise * (positive + negative + std::abs(along))) return GeneratorKind::null_pair;
  return square > 0 ? GeneratorKind::real_pair : GeneratorKind::imaginary_pair;
}

/// Leaves out of a part what is round-off of the coefficients it was taken from: a part that slides has no place, and
/// one that turns about a line has no tangent.
Generator without_remainders(const Generator& part, const Generator& whole) {
  const auto kept = [](const Vector& coefficient, const Vector& from) {
    return length(coefficient) > remainder * length(from) ? coefficient : Vector{};
  };
  const bool slope = std::abs(part.no_ni) > remainder * std::abs(whole.no_ni);
  return {kept(part.no_e, whole.no_e), kept(part.e_e, whole.e_e), slope ? part.no_ni : 0.0,
          kept(part.e_ni, whole.e_ni)};
}

/// The parts of B from those of B^2 = S + Q with Q = 2 B1 B2: B Q / 2 = l+ B2 + l- B1 for the squares l+ and l- of the
/// parts, so (l+ - l-) B1 = l+ B - B Q / 2. False when the squares agree.
bool split(const Generator& generator, std::array<Generator, 2>& parts) {
  const Versor b = versor_from(0, generator);
  const Versor square = compose(b, b);
  const Versor quad{0, {}, square.quad};
  const double S = square.scalar, q = compose(quad, quad).scalar;
  const double gap = std::sqrt(std::max(S * S - q, 0.0));
  if (!(gap > smallest_split * (std::abs(S) + std::sqrt(std::abs(q))))) return false;
  const double larger = (S + gap) / 2;
  parts[0] = (1 / gap) * (larger * generator + -0.5 * compose(b, quad).bivector);
  parts[1] = without_remainders(generator + -1.0 * parts[0], generator);
  parts[0] = without_remainders(parts[0], generator);
  return true;
}

}  // namespace

GeneratorKind kind_of(const Generator& generator, double noise) {
  if (generator == Generator{}) return GeneratorKind::zero;
  if (!is_simple(generator, noise)) return GeneratorKind::general;
  if (generator.no_e != Vector{}) return kind_of_pair(generator, noise);
  if (generator.e_e != Vector{}) return GeneratorKind::rotation;
  return generator.no_ni != 0 ? GeneratorKind::flat_point : GeneratorKind::direction;
}

std::array<Generator, 2> commuting_parts(const Generator& generator) {
  if (kind_of(generator) != GeneratorKind::general) return {generator, {}};
  std::array<Generator, 2> parts{generator, {}};
  if (split(generator, parts)) return parts;
  // A little more of the turn about the axis through the generator's own place makes its planes distinct.
  const Vector place = to_vector(kernels::warp_source(generator).position);
  Generator nudged = seen_from(generator, place);
  nudged.e_e = (1 + nudge) * nudged.e_e;
  split(seen_from(nudged, -place), parts);
  return parts;
}

}  // namespace dini

// The sums of a warp over its generators, seen from the points; compiled once per instruction set.
//
// With y = c - p for a generator T(c, t), seen from p: A = t, W = y x t, e = y.t, M = e y - |y|^2/2 t.
// Relative to the point these keep their digits however near it is; in global coordinates they would lose (|c|/|y|)^2.

#if defined(DINI_ALGEBRA_WARP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DINI_ALGEBRA_WARP_INL_H_
#undef DINI_ALGEBRA_WARP_INL_H_
#else
#define DINI_ALGEBRA_WARP_INL_H_
#endif

#include <cmath>
#include <optional>
#include <span>

#include "algebra/kernels-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace dini::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// How the weight strength / (d^power + softening) is computed.
enum class Falloff { inverse_square, softened_square, quarters, general };

/// A power of the squared distance that takes no logarithm: `whole` factors, and of the fourth root as many as
/// `quarters` says.
struct QuarterPower {
  int whole = 0, quarters = 0;
};

/// Nothing for powers that are no quarters, are negative, or so large that a logarithm is quicker.
inline std::optional<QuarterPower> quarter_power(double half_power) {
  constexpr int most = 8;
  const double in_quarters = 4 * half_power;
  if (!(in_quarters >= 0 && in_quarters <= 4 * most) || in_quarters != std::floor(in_quarters)) return std::nullopt;
  const int number = static_cast<int>(in_quarters);
  return QuarterPower{number / 4, number % 4};
}

/// x to such a power, x >= 0.
HWY_INLINE Lanes power_by_roots(Lanes x, QuarterPower power) {
  const Tag d;
  Lanes result = hn::Set(d, 1.0);
  for (int k = 0; k < power.whole; ++k) result = result * x;
  if (power.quarters == 0) return result;
  const Lanes root = hn::Sqrt(x);
  if (power.quarters >= 2) result = result * root;
  return power.quarters == 2 ? result : result * hn::Sqrt(root);
}

/// The settings of a warp in every lane.
struct WarpLanes {
  Lanes strength, softening, half_power;
  QuarterPower power;
};

inline WarpLanes lanes_of(const kernels::WarpSettings& settings) {
  const Tag d;
  const double half_power = 0.5 * settings.power;
  return {hn::Set(d, settings.strength), hn::Set(d, settings.softening), hn::Set(d, half_power),
          quarter_power(half_power).value_or(QuarterPower{})};
}

template <Falloff falloff>
HWY_INLINE Lanes weight_at(Lanes squared_distance, const WarpLanes& settings) {
  if constexpr (falloff == Falloff::inverse_square) return settings.strength / squared_distance;
  if constexpr (falloff == Falloff::softened_square) return settings.strength / (squared_distance + settings.softening);
  if constexpr (falloff == Falloff::quarters) {
    return settings.strength / (power_by_roots(squared_distance, settings.power) + settings.softening);
  }
  return settings.strength / (power_of(Tag(), squared_distance, settings.half_power) + settings.softening);
}

HWY_INLINE Bivector<Lanes> no_generator() {
  const Lanes zero = hn::Zero(Tag());
  return {{zero, zero, zero}, {zero, zero, zero}, zero, {zero, zero, zero}};
}

/// Adds null pairs seen from p, weighted. With the falloff of an inverse square M lacks the term that is the same for
/// all points.
template <Falloff falloff>
HWY_INLINE void add_pairs(std::span<const kernels::WarpSource> sources, const WarpLanes& settings,
                          const Triple<Lanes>& p, Bivector<Lanes>& sum) {
  const Tag d;
  const Lanes half = hn::Set(d, 0.5);
  for (const kernels::WarpSource& source : sources) {
    const Triple<Lanes> y = broadcast(to_vector(source.position)) - p;
    const Triple<Lanes> t = broadcast(source.generator.no_e);
    const Lanes yy = dot(y, y);
    const Lanes w = weight_at<falloff>(yy, settings);
    const Triple<Lanes> tangent = w * t;
    const Lanes e = dot(y, tangent);
    sum.A = sum.A + tangent;
    sum.W = sum.W + cross(y, tangent);
    sum.e = sum.e + e;
    if constexpr (falloff == Falloff::inverse_square) {
      sum.M = sum.M + e * y;  // w |y|^2 is the strength: the other term is the same for all points
    } else {
      sum.M = sum.M + (e * y - (half * yy) * tangent);
    }
  }
}

/// What a generator has beyond the null pair at its position: a bivector without no^e part, seen from that position.
struct Remainder {
  Vector W;
  double e;
  Vector M;
};
inline Remainder remainder_of(const kernels::WarpSource& source) {
  const Bivector<double> centered = seen_from(bivector(source.generator), triple(source.position), 0.5);
  return {vector(centered.W), centered.e, vector(centered.M)};
}

/// Any generator seen from p, not weighted; y = c - p.
HWY_INLINE Bivector<Lanes> seen_from_point(const kernels::WarpSource& source, const Triple<Lanes>& y, Lanes yy) {
  const Tag d;
  const Remainder rest = remainder_of(source);
  const Triple<Lanes> t = broadcast(source.generator.no_e), W = broadcast(rest.W);
  const Lanes e_rest = hn::Set(d, rest.e);
  const Lanes e = dot(y, t);
  return {t, cross(y, t) + W, e + e_rest,
          (e * y - (hn::Set(d, 0.5) * yy) * t) + ((broadcast(rest.M) + e_rest * y) - cross(W, y))};
}

/// Adds any generators seen from p, weighted.
template <Falloff falloff>
HWY_INLINE void add_generators(std::span<const kernels::WarpSource> sources, const WarpLanes& settings,
                               const Triple<Lanes>& p, Bivector<Lanes>& sum) {
  for (const kernels::WarpSource& source : sources) {
    const Triple<Lanes> y = broadcast(to_vector(source.position)) - p;
    const Lanes yy = dot(y, y);
    const Lanes w = weight_at<falloff>(yy, settings);
    const Bivector<Lanes> b = seen_from_point(source, y, yy);
    sum = {sum.A + w * b.A, sum.W + w * b.W, sum.e + w * b.e, sum.M + w * b.M};
  }
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

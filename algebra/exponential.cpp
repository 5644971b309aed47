#include <algorithm>
#include <cmath>

#include "algebra/exponential-inl.h"
#include "algebra/versor.h"

namespace dini {

namespace {

namespace lanes = HWY_NAMESPACE;
namespace hn = hwy::HWY_NAMESPACE;

using One = hn::CappedTag<double, 1>;
using Lane = hn::Vec<One>;
constexpr One one_lane;

lanes::Triple<Lane> lane(const Vector& v) {
  return {hn::Set(one_lane, v.x), hn::Set(one_lane, v.y), hn::Set(one_lane, v.z)};
}

lanes::Squares<Lane> squares(const Generator& g) {
  return lanes::squares_of(one_lane, {lane(g.no_e), lane(g.e_e), hn::Set(one_lane, g.no_ni), lane(g.e_ni)});
}

bool usable(const lanes::Squares<Lane>& value) {
  const double S = hn::GetLane(value.S), q = hn::GetLane(value.q);
  return std::isfinite(S * S) && std::isfinite(q);
}

double largest_coefficient(const Generator& g) {
  return std::max({std::abs(g.no_e.x), std::abs(g.no_e.y), std::abs(g.no_e.z), std::abs(g.e_e.x), std::abs(g.e_e.y),
                   std::abs(g.e_e.z), std::abs(g.no_ni), std::abs(g.e_ni.x), std::abs(g.e_ni.y), std::abs(g.e_ni.z)});
}

}  // namespace

Versor exponential(const Generator& given, Rule rule) {
  Generator g = given;
  auto value = squares(g);
  if (!usable(value)) {
    // Only the direction of such a generator is left: it has saturated or its angle has no digits.
    const double largest = largest_coefficient(g);
    if (!std::isfinite(largest)) return Versor{0, {}, {}};
    g = (tolerance::saturated_generator / largest) * g;
    value = squares(g);
  }
  const auto k =
      rule == Rule::exact ? lanes::exact_coefficients(one_lane, value) : lanes::paper_coefficients(one_lane, value);
  const double hyperbolic = hn::GetLane(k.hyperbolic);
  const double scale = hyperbolic > 0 && rule == Rule::exact && hyperbolic <= tolerance::largest_hyperbolic_argument
                           ? elementary::cosh(hyperbolic)
                           : 1;
  const double c0 = scale * hn::GetLane(k.c0), s2 = scale * hn::GetLane(k.s2);
  const double h = scale * hn::GetLane(k.h), g3 = scale * hn::GetLane(k.g);

  const Generator linear = h * g;
  if (rule == Rule::paper) return {c0, linear, {}};
  const Sphere quad{2 * dot(g.no_e, g.e_e), 2 * (g.no_ni * g.e_e + cross(g.no_e, g.e_ni)), 2 * dot(g.e_ni, g.e_e)};
  const Versor cubic = compose({0, {}, quad}, {0, g, {}});
  // Q B has no scalar and no grade-4 part for any bivector B
  return {c0, linear + g3 * cubic.bivector, {s2 * quad.no, s2 * quad.e, s2 * quad.ni}};
}

}  // namespace dini

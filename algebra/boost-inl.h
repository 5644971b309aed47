// One null generator on points, in the closed form that keeps its digits everywhere; compiled once per instruction set.

#if defined(DINI_ALGEBRA_BOOST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DINI_ALGEBRA_BOOST_INL_H_
#undef DINI_ALGEBRA_BOOST_INL_H_
#else
#define DINI_ALGEBRA_BOOST_INL_H_
#endif

#include "algebra/kernels-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace dini::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A point as base + offset.
struct Boosted {
  LaneMask near;  ///< the offset is from the point itself; elsewhere from the generator
  Triple<Lanes> offset;
};

/// exp(T(c, a)) on the point c + y, yy = |y|^2. With |a||y| small the displacement (yy a - (2 a.y + |a|^2 yy) y) / (1 +
/// 2 a.y + |a|^2 yy) has no cancellation; otherwise inversion, shift, inversion has none: q / |q|^2 with q = y / yy +
/// a.
HWY_INLINE Boosted boosted(const Triple<Lanes>& y, Lanes yy, const Triple<Lanes>& a) {
  const Tag d;
  const Lanes one = hn::Set(d, 1.0);
  const Lanes twice = hn::Set(d, 2.0) * dot(a, y);
  const Lanes stretch = dot(a, a) * yy;
  const LaneMask near = hn::Lt(stretch, hn::Set(d, 0.25));
  const Lanes growth = twice + stretch;
  const Triple<Lanes> q = one / yy * y + a;
  const Triple<Lanes> numerator = select(near, yy * a - growth * y, q);
  const Lanes weight = hn::IfThenElse(near, one + growth, dot(q, q));
  return {near, one / weight * numerator};
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

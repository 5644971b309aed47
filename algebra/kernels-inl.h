// Loading and storing columns of points, shared by every kernel; compiled once per instruction set.
//
// The last, partial block goes through a padded buffer instead of a scalar loop, so every element meets the same
// operations.

#if defined(DINI_ALGEBRA_KERNELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DINI_ALGEBRA_KERNELS_INL_H_
#undef DINI_ALGEBRA_KERNELS_INL_H_
#else
#define DINI_ALGEBRA_KERNELS_INL_H_
#endif

#include <cstddef>
#include <limits>

#include "algebra/exponential-inl.h"
#include "algebra/kernels.h"
#include "algebra/quaternion-inl.h"
#include "algebra/tolerance.h"
#include "algebra/versor.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace dini::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<double>;
using Lanes = hn::Vec<Tag>;
using LaneMask = hn::Mask<Tag>;
inline constexpr std::size_t most_lanes = hn::MaxLanes(Tag());

/// The elements [first, first + valid) of a column; `valid` is at most the number of lanes.
struct Range {
  std::size_t first, valid;
};

/// Calls body(range) for consecutive ranges that cover `count` elements.
template <class Body>
HWY_INLINE void for_each_range(std::size_t count, Body body) {
  const std::size_t lanes = hn::Lanes(Tag());
  for (std::size_t first = 0; first < count; first += lanes) {
    body(Range{first, count - first < lanes ? count - first : lanes});
  }
}

HWY_INLINE Lanes load(const double* values, Range range) {
  const Tag d;
  if (HWY_LIKELY(range.valid == hn::Lanes(d))) return hn::LoadU(d, values + range.first);
  HWY_ALIGN double buffer[most_lanes];
  for (std::size_t i = 0; i < most_lanes; ++i) buffer[i] = values[range.first + (i < range.valid ? i : 0)];
  return hn::Load(d, buffer);
}

HWY_INLINE Lanes load(kernels::ConstNumbers numbers, Range range) {
  return numbers.constant ? hn::Set(Tag(), numbers.values[0]) : load(numbers.values, range);
}

HWY_INLINE void store(Lanes value, double* values, Range range) {
  const Tag d;
  if (HWY_LIKELY(range.valid == hn::Lanes(d))) {
    hn::StoreU(value, d, values + range.first);
    return;
  }
  HWY_ALIGN double buffer[most_lanes];
  hn::Store(value, d, buffer);
  for (std::size_t i = 0; i < range.valid; ++i) values[range.first + i] = buffer[i];
}

/// Points of a range; those at infinity (or as good as) are marked and replaced by the origin.
struct PointLanes {
  Triple<Lanes> position;
  LaneMask infinite;
};

HWY_INLINE PointLanes load(kernels::ConstPoints points, Range range) {
  const Tag d;
  const Triple<Lanes> p{load(points.x, range), load(points.y, range), load(points.z, range)};
  const Lanes limit = hn::Set(d, tolerance::infinite_distance);
  const LaneMask finite =
      hn::And(hn::And(hn::Le(hn::Abs(p.x), limit), hn::Le(hn::Abs(p.y), limit)), hn::Le(hn::Abs(p.z), limit));
  return {{hn::IfThenElseZero(finite, p.x), hn::IfThenElseZero(finite, p.y), hn::IfThenElseZero(finite, p.z)},
          hn::Not(finite)};
}

/// True where all coordinates are finite.
HWY_INLINE LaneMask is_finite(const Triple<Lanes>& p) {
  return hn::Eq(((p.x - p.x) + (p.y - p.y)) + (p.z - p.z), hn::Zero(Tag()));
}

HWY_INLINE Triple<Lanes> select(LaneMask mask, const Triple<Lanes>& yes, const Triple<Lanes>& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}

HWY_INLINE Triple<Lanes> broadcast(const Vector& v) {
  const Tag d;
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

/// Stores points; whatever is not finite becomes the point at infinity.
HWY_INLINE void store(const Triple<Lanes>& p, kernels::Points points, Range range) {
  const Tag d;
  const Lanes infinity = hn::Set(d, std::numeric_limits<double>::infinity());
  const Triple<Lanes> stored = select(is_finite(p), p, {infinity, infinity, infinity});
  store(stored.x, points.x, range);
  store(stored.y, points.y, range);
  store(stored.z, points.z, range);
}

/// Where an image has to be computed without the point that it comes from.
HWY_INLINE LaneMask is_much_nearer(const Triple<Lanes>& image, const Triple<Lanes>& p) {
  return hn::Lt(dot(image, image), hn::Set(Tag(), tolerance::much_nearer) * dot(p, p));
}

/// Where exp(B) sends points: p + displacement. `local` is B seen from the points, `squares` those of B.
template <bool exact>
HWY_INLINE Triple<Lanes> displaced(const Triple<Lanes>& p, const Bivector<Lanes>& local,
                                   const Squares<Lanes>& squares) {
  const Tag d;
  const auto k = exact ? exact_coefficients(d, squares) : paper_coefficients(d, squares);
  const Image<Lanes> image = image_of_origin<exact>(d, local, k);
  return p + hn::Set(d, 1.0) / image.weight * image.numerator;
}

/// Where exp(B) sends infinity, for the marked lanes of `image`; lane by lane, since it hardly ever happens.
HWY_INLINE void place_infinite(LaneMask infinite, const Bivector<Lanes>& b, Rule rule, Triple<Lanes>& image) {
  const Tag d;
  if (HWY_LIKELY(hn::AllFalse(d, infinite))) return;
  HWY_ALIGN double lane[10][most_lanes], x[most_lanes], y[most_lanes], z[most_lanes];
  const Lanes components[10] = {b.A.x, b.A.y, b.A.z, b.W.x, b.W.y, b.W.z, b.e, b.M.x, b.M.y, b.M.z};
  for (int k = 0; k < 10; ++k) hn::Store(components[k], d, lane[k]);
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
    const Generator g{{lane[0][i], lane[1][i], lane[2][i]},
                      {lane[3][i], lane[4][i], lane[5][i]},
                      lane[6][i],
                      {lane[7][i], lane[8][i], lane[9][i]}};
    const Point moved = apply(exponential(g, rule), Point::at_infinity()).value_or(Point::at_infinity());
    x[i] = moved.x;
    y[i] = moved.y;
    z[i] = moved.z;
  }
  image = select(infinite, {hn::Load(d, x), hn::Load(d, y), hn::Load(d, z)}, image);
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

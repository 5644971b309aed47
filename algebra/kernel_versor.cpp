#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algebra/kernel_versor.cpp"
// clang-format off: this compiles the file once per instruction set, so it comes before all other headers
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// clang-format on

#include "algebra/kernels-inl.h"
#include "algebra/versor.h"

HWY_BEFORE_NAMESPACE();
namespace dini::HWY_NAMESPACE {

HWY_INLINE Quaternion<Lanes> broadcast(const Quaternion<double>& q) {
  const Tag d;
  return {hn::Set(d, q.s), {hn::Set(d, q.v.x), hn::Set(d, q.v.y), hn::Set(d, q.v.z)}};
}

/// q times the pure quaternion v.
HWY_INLINE Quaternion<Lanes> times_vector(const Quaternion<Lanes>& q, const Triple<Lanes>& v) {
  return {hn::Zero(Tag()) - dot(q.v, v), q.s * v - cross(q.v, v)};
}
/// The pure quaternion v times q.
HWY_INLINE Quaternion<Lanes> vector_times(const Triple<Lanes>& v, const Quaternion<Lanes>& q) {
  return {hn::Zero(Tag()) - dot(v, q.v), q.s * v - cross(v, q.v)};
}

void versor_lanes(const Versor& versor, const Point& infinity_image, kernels::ConstPoints in, kernels::Points out,
                  std::size_t count) {
  const Tag d;
  const Matrix<double> m = matrix(versor);
  const Quaternion<Lanes> a = broadcast(m.a), b = broadcast(m.b), c = broadcast(m.c), e = broadcast(m.d);
  const Triple<Lanes> zero{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  const Triple<Lanes> far = broadcast(to_vector(infinity_image));
  for_each_range(count, [=](Range range) HWY_ATTR {
    // the first column of the matrix, seen from the point
    const PointLanes p = load(in, range);
    const Triple<Lanes> shift = zero - p.position;
    const Quaternion<Lanes> weight = a + times_vector(b, shift);
    const Quaternion<Lanes> rest = c + times_vector(e, shift);
    const Quaternion<Lanes> moved = rest + vector_times(p.position, weight);
    const Lanes scale = hn::Set(d, 1.0) / squared_size(weight);
    Triple<Lanes> image = p.position + scale * vector_of_ratio(weight, moved);
    const LaneMask nearer = is_much_nearer(image, p.position);
    if (HWY_UNLIKELY(!hn::AllFalse(d, nearer))) {
      image = select(nearer, scale * vector_of_ratio(weight, rest), image);
    }
    store(select(p.infinite, far, image), out, range);
  });
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dini {
HWY_EXPORT(versor_lanes);

namespace kernels {
void transform_points(const Versor& versor, ConstPoints in, Points out, std::size_t count) {
  const Point infinity_image = apply(versor, Point::at_infinity()).value_or(Point::at_infinity());
  HWY_DYNAMIC_DISPATCH(versor_lanes)(versor, infinity_image, in, out, count);
}
}  // namespace kernels
}  // namespace dini
#endif

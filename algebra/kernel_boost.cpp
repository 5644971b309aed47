#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algebra/kernel_boost.cpp"
// clang-format off: this compiles the file once per instruction set, so it comes before all other headers
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// clang-format on

#include "algebra/boost-inl.h"
#include "algebra/kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dini::HWY_NAMESPACE {

void boost_lanes(const Point& position, const Vector& tangent, kernels::ConstNumbers amounts, kernels::ConstPoints in,
                 kernels::Points out, std::size_t count) {
  const Tag d;
  const Triple<Lanes> c = broadcast(to_vector(position)), t = broadcast(tangent);
  for_each_range(count, [=](Range range) HWY_ATTR {
    const PointLanes p = load(in, range);
    const Triple<Lanes> a = load(amounts, range) * t;
    const Triple<Lanes> y = p.position - c;
    const Boosted moved = boosted(y, dot(y, y), a);
    Triple<Lanes> image = select(moved.near, p.position, c) + moved.offset;
    if (HWY_UNLIKELY(!hn::AllFalse(d, p.infinite))) {
      // c + a/|a|^2, scaled so that |a|^2 neither overflows nor vanishes; a = 0 leaves infinity where it is
      const Lanes size = hn::Max(hn::Max(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
      const Triple<Lanes> unit = hn::Set(d, 1.0) / size * a;
      image = select(p.infinite, c + hn::Set(d, 1.0) / dot(unit, unit) / size * unit, image);
    }
    store(image, out, range);
  });
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dini {
HWY_EXPORT(boost_lanes);

namespace kernels {
void boost_points(const Point& position, const Vector& tangent, ConstNumbers amounts, ConstPoints in, Points out,
                  std::size_t count) {
  HWY_DYNAMIC_DISPATCH(boost_lanes)(position, tangent, amounts, in, out, count);
}
}  // namespace kernels
}  // namespace dini
#endif

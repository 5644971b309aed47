#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algebra/kernel_generator.cpp"
// clang-format off: this compiles the file once per instruction set, so it comes before all other headers
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// clang-format on

#include "algebra/kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dini::HWY_NAMESPACE {

HWY_INLINE Bivector<Lanes> load(kernels::ConstGenerators generators, Range range) {
  const auto component = [&](int k) HWY_ATTR {
    return load(kernels::ConstNumbers{generators.components[k], generators.constant}, range);
  };
  return {{component(0), component(1), component(2)},
          {component(3), component(4), component(5)},
          component(6),
          {component(7), component(8), component(9)}};
}

HWY_INLINE Bivector<Lanes> broadcast(const Generator& g) {
  return {broadcast(g.no_e), broadcast(g.e_e), hn::Set(Tag(), g.no_ni), broadcast(g.e_ni)};
}

HWY_INLINE Bivector<Lanes> operator+(const Bivector<Lanes>& a, const Bivector<Lanes>& b) {
  return {a.A + b.A, a.W + b.W, a.e + b.e, a.M + b.M};
}

/// exp(amount B) on the points of one range.
template <bool exact>
HWY_INLINE void transform_range(const Bivector<Lanes>& b, Lanes amount, kernels::ConstPoints in, kernels::Points out,
                                Range range) {
  const Tag d;
  const PointLanes p = load(in, range);
  const Bivector<Lanes> scaled = amount * b;
  const Bivector<Lanes> local = seen_from(scaled, p.position, hn::Set(d, 0.5));
  Triple<Lanes> image = displaced<exact>(p.position, local, squares_of(d, scaled));
  place_infinite(p.infinite, scaled, exact ? Rule::exact : Rule::paper, image);
  store(image, out, range);
}

template <bool exact>
void generator_range_loop(kernels::ConstGenerators generators, kernels::ConstNumbers amounts, kernels::ConstPoints in,
                          kernels::Points out, std::size_t count) {
  for_each_range(count, [=](Range range) HWY_ATTR {
    transform_range<exact>(load(generators, range), load(amounts, range), in, out, range);
  });
}

void generator_lanes(kernels::ConstGenerators generators, kernels::ConstNumbers amounts, Rule rule,
                     kernels::ConstPoints in, kernels::Points out, std::size_t count) {
  const auto loop = rule == Rule::exact ? generator_range_loop<true> : generator_range_loop<false>;
  loop(generators, amounts, in, out, count);
}

template <bool exact>
void bilinear_range_loop(const kernels::BilinearCorners& corners, kernels::ConstNumbers u, kernels::ConstNumbers v,
                         kernels::ConstNumbers amounts, kernels::ConstPoints in, kernels::Points out,
                         std::size_t count) {
  const Tag d;
  const Bivector<Lanes> b00 = broadcast(corners.a), b10 = broadcast(corners.b);
  const Bivector<Lanes> b01 = broadcast(corners.c), b11 = broadcast(corners.d);
  const Lanes one = hn::Set(d, 1.0);
  for_each_range(count, [&](Range range) HWY_ATTR {
    const Lanes right = load(u, range), top = load(v, range);
    const Lanes left = one - right, bottom = one - top;
    const Bivector<Lanes> blend =
        ((left * bottom) * b00 + (right * bottom) * b10) + ((left * top) * b01 + (right * top) * b11);
    transform_range<exact>(blend, load(amounts, range), in, out, range);
  });
}

void bilinear_lanes(const kernels::BilinearCorners& corners, kernels::ConstNumbers u, kernels::ConstNumbers v,
                    kernels::ConstNumbers amounts, Rule rule, kernels::ConstPoints in, kernels::Points out,
                    std::size_t count) {
  const auto loop = rule == Rule::exact ? bilinear_range_loop<true> : bilinear_range_loop<false>;
  loop(corners, u, v, amounts, in, out, count);
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dini {
HWY_EXPORT(generator_lanes);
HWY_EXPORT(bilinear_lanes);

namespace kernels {
void transform_points(ConstGenerators generators, ConstNumbers amounts, Rule rule, ConstPoints in, Points out,
                      std::size_t count) {
  HWY_DYNAMIC_DISPATCH(generator_lanes)(generators, amounts, rule, in, out, count);
}

void transform_points_bilinear(const BilinearCorners& corners, ConstNumbers u, ConstNumbers v, ConstNumbers amounts,
                               Rule rule, ConstPoints in, Points out, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(bilinear_lanes)(corners, u, v, amounts, rule, in, out, count);
}
}  // namespace kernels
}  // namespace dini
#endif

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

HWY_INLINE Quaternion<Lanes> operator*(Lanes s, const Quaternion<Lanes>& q) { return {s * q.s, s * q.v}; }

/// Where exp B sends points, by its matrix in the coordinates of B: c0 + s2 Q + h B + g Q B with
///   Q = [ -y, -alpha; -2 beta, y ],  B = [ W - e, A; 2 M, W + e ].
template <bool exact>
HWY_INLINE Triple<Lanes> image_from_afar(const Triple<Lanes>& p, const Bivector<Lanes>& b,
                                         const Coefficients<Lanes>& k) {
  const Tag d;
  const Lanes zero = hn::Zero(d), two = hn::Set(d, 2.0);
  const Triple<Lanes> none{zero, zero, zero};
  const Quaternion<Lanes> B00{zero - b.e, b.W}, B01{zero, b.A}, B10{zero, two * b.M}, B11{b.e, b.W};
  Quaternion<Lanes> a = k.h * B00, o = k.h * B01, c = k.h * B10, e = k.h * B11;
  a.s = a.s + k.c0;
  e.s = e.s + k.c0;
  if constexpr (exact) {
    const Triple<Lanes> y = two * (b.e * b.W + cross(b.A, b.M));
    const Quaternion<Lanes> Q00{zero, none - y}, Q01{zero - two * dot(b.A, b.W), none},
        Q10{zero - (two * two) * dot(b.M, b.W), none}, Q11{zero, y};
    a = a + (k.s2 * Q00 + k.g * (Q00 * B00 + Q01 * B10));
    o = o + (k.s2 * Q01 + k.g * (Q00 * B01 + Q01 * B11));
    c = c + (k.s2 * Q10 + k.g * (Q10 * B00 + Q11 * B10));
    e = e + (k.s2 * Q11 + k.g * (Q10 * B01 + Q11 * B11));
  }
  const Quaternion<Lanes> shift{zero, none - p};
  const Quaternion<Lanes> weight = a + o * shift, rest = c + e * shift;
  return hn::Set(d, 1.0) / squared_size(weight) * vector_of_ratio(weight, rest);
}

/// The size of the terms that the square of a bivector is the difference of.
HWY_INLINE Lanes size_of_terms(const Bivector<Lanes>& b) {
  return b.e * b.e + dot(b.W, b.W) + hn::Abs(hn::Set(Tag(), 2.0) * dot(b.A, b.M));
}

/// exp(amount B) on the points of one range.
template <bool exact>
HWY_INLINE void transform_range(const Bivector<Lanes>& b, Lanes amount, kernels::ConstPoints in, kernels::Points out,
                                Range range) {
  const Tag d;
  const PointLanes p = load(in, range);
  const Bivector<Lanes> scaled = amount * b;
  const Bivector<Lanes> local = seen_from(scaled, p.position, hn::Set(d, 0.5));
  const Squares<Lanes> squares = squares_of(d, scaled);
  Triple<Lanes> image = displaced<exact>(p.position, local, squares);
  const LaneMask afar =
      hn::Or(is_much_nearer(image, p.position),
             hn::Gt(size_of_terms(local), hn::Set(d, tolerance::seen_from_afar) * size_of_terms(scaled)));
  if (HWY_UNLIKELY(!hn::AllFalse(d, afar))) {
    const auto k = exact ? exact_coefficients(d, squares) : paper_coefficients(d, squares);
    image = select(afar, image_from_afar<exact>(p.position, scaled, k), image);
  }
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

// Elementary functions over SIMD lanes, compiled once per instruction set. No fused multiply-add: the bits never depend
// on the width. Coefficients are those published with Sun's fdlibm (1993).

#if defined(DINI_ALGEBRA_ELEMENTARY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DINI_ALGEBRA_ELEMENTARY_INL_H_
#undef DINI_ALGEBRA_ELEMENTARY_INL_H_
#else
#define DINI_ALGEBRA_ELEMENTARY_INL_H_
#endif

#include <cstddef>

#include "algebra/elementary.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace dini::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Adding this rounds |x| < 2^51 to the nearest integer (ties to even), which then sits in the low bits.
inline constexpr double rounding_magic = 0x1.8p52;

template <class D, class V = hn::Vec<D>>
HWY_INLINE V constant(D d, double value) {
  return hn::Set(d, value);
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V polynomial(D, V, V sum) {
  return sum;
}

/// Horner: sum * x + c1, ..., from the highest coefficient to the lowest.
template <class D, class V = hn::Vec<D>, class... C>
HWY_INLINE V polynomial(D d, V x, V sum, double next, C... rest) {
  return polynomial(d, x, sum * x + hn::Set(d, next), rest...);
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V round_to_integer(D d, V x) {
  const V magic = hn::Set(d, rounding_magic);
  return (x + magic) - magic;
}

/// 2^n for integers n in [-1022, 1023].
template <class D, class V = hn::Vec<D>>
HWY_INLINE V power_of_two(D d, V n) {
  const hn::RebindToSigned<D> di;
  return hn::BitCast(d, hn::ShiftLeft<52>(hn::BitCast(di, n + hn::Set(d, rounding_magic + 1023))));
}

/// An unevaluated sum of two numbers.
template <class V>
struct Pair {
  V high, low;
};

/// The exact product of a and b (Dekker 1971), barring overflow.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Pair<V> exact_product(D d, V a, V b) {
  const V splitter = hn::Set(d, 134217729.0);
  const V a_scaled = splitter * a, b_scaled = splitter * b;
  const V a_high = a_scaled - (a_scaled - a), b_high = b_scaled - (b_scaled - b);
  const V a_low = a - a_high, b_low = b - b_high;
  const V product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

/// x = n log 2 + r with |r| <= log(2)/2; `remainder` is e^r - 1.
template <class V>
struct ReducedExponential {
  V n, remainder;
};
template <class D, class V = hn::Vec<D>>
HWY_INLINE ReducedExponential<V> reduced_exponential(D d, V x) {
  const V n = round_to_integer(d, x * hn::Set(d, 1.44269504088896338700e+00));
  const V high = x - n * hn::Set(d, 6.93147180369123816490e-01);
  const V low = n * hn::Set(d, 1.90821492927058770002e-10);
  const V r = high - low;
  const V t = r * r;
  const V c = r - t * polynomial(d, t, hn::Set(d, 4.13813679705723846039e-08), -1.65339022054652515390e-06,
                                 6.61375632143793436117e-05, -2.77777777770155933842e-03, 1.66666666666666019037e-01);
  return {n, high - (low - r * c / (hn::Set(d, 2.0) - c))};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V exponential_of(D d, V x) {
  const V limited = hn::Min(hn::Max(x, hn::Set(d, -750.0)), hn::Set(d, 710.0));
  const auto reduced = reduced_exponential(d, limited);
  const V half = round_to_integer(d, reduced.n * hn::Set(d, 0.5));
  const V value = (hn::Set(d, 1.0) + reduced.remainder) * power_of_two(d, half) * power_of_two(d, reduced.n - half);
  return hn::IfThenElse(hn::Eq(x, x), value, x);
}

/// e^x - 1 for |x| <= 700, accurate near zero.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V exponential_minus_one(D d, V x) {
  const auto reduced = reduced_exponential(d, x);
  const V scale = power_of_two(d, reduced.n);
  return scale * reduced.remainder + (scale - hn::Set(d, 1.0));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V tanh_of(D d, V x) {
  const V magnitude = hn::Min(hn::Abs(x), hn::Set(d, 22.0));
  const V t = exponential_minus_one(d, magnitude + magnitude);
  return hn::CopySign(t / (t + hn::Set(d, 2.0)), x);
}

template <class V>
struct SineCosineLanes {
  V sine, cosine;
};

/// Sine and cosine of quadrant * pi/2 + high + low, |high| <= pi/4; any integer quadrant below 2^50.
template <class D, class V = hn::Vec<D>>
HWY_INLINE SineCosineLanes<V> sincos_of_reduced(D d, V quadrant, V high, V low) {
  const hn::RebindToSigned<D> di;
  const V half = hn::Set(d, 0.5), one = hn::Set(d, 1.0);
  const V z = high * high;
  const V v = z * high;
  const V s = polynomial(d, z, hn::Set(d, 1.58969099521155010221e-10), -2.50507602534068634195e-08,
                         2.75573137070700676789e-06, -1.98412698298579493134e-04, 8.33333333332248946124e-03);
  const V sine = high - ((z * (half * low - v * s) - low) - v * hn::Set(d, -1.66666666666666324348e-01));
  const V c = z * polynomial(d, z, hn::Set(d, -1.13596475577881948265e-11), 2.08757232129817482790e-09,
                             -2.75573143513906633035e-07, 2.48015872894767294178e-05, -1.38888888888741095749e-03,
                             4.16666666666666019037e-02);
  const V hz = half * z;
  const V w = one - hz;
  const V cosine = w + (((one - w) - hz) + (z * c - high * low));

  const auto bits = hn::BitCast(di, quadrant + hn::Set(d, rounding_magic));
  const auto one_bit = hn::Set(di, 1), two_bit = hn::Set(di, 2);
  const auto swapped = hn::RebindMask(d, hn::Eq(hn::And(bits, one_bit), one_bit));
  const V sine_sign = hn::BitCast(d, hn::ShiftLeft<62>(hn::And(bits, two_bit)));
  const V cosine_sign = hn::BitCast(d, hn::ShiftLeft<62>(hn::And(bits + one_bit, two_bit)));
  return {hn::Xor(hn::IfThenElse(swapped, cosine, sine), sine_sign),
          hn::Xor(hn::IfThenElse(swapped, sine, cosine), cosine_sign)};
}

/// Sine and cosine of any finite x: Cody and Waite's reduction (three parts of pi/2) up to 10^6, an exact one beyond.
template <class D, class V = hn::Vec<D>>
HWY_INLINE SineCosineLanes<V> sincos_of(D d, V x) {
  V n = round_to_integer(d, x * hn::Set(d, 6.36619772367581382433e-01));
  const V first = x - n * hn::Set(d, 1.57079632673412561417e+00);
  const V second_part = n * hn::Set(d, 6.07710050630396597660e-11);
  const V second = first - second_part;
  const V third_part = n * hn::Set(d, 2.02226624871116645580e-21) -
                       (((first - second) - second_part) - n * hn::Set(d, 8.47842766036889956997e-32));
  V high = second - third_part;
  V low = (second - high) - third_part;
  const auto large = hn::Not(hn::Le(hn::Abs(x), hn::Set(d, 1e6)));
  if (HWY_UNLIKELY(!hn::AllFalse(d, large))) {
    constexpr std::size_t lanes = hn::MaxLanes(D());
    HWY_ALIGN double values[lanes], quadrants[lanes], highs[lanes], lows[lanes];
    hn::Store(x, d, values);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
      const auto reduced = elementary::reduce_large_angle(values[i]);
      quadrants[i] = reduced.quadrant;
      highs[i] = reduced.high;
      lows[i] = reduced.low;
    }
    n = hn::IfThenElse(large, hn::Load(d, quadrants), n);
    high = hn::IfThenElse(large, hn::Load(d, highs), high);
    low = hn::IfThenElse(large, hn::Load(d, lows), low);
  }
  return sincos_of_reduced(d, n, high, low);
}

/// log x = high + low to about 59 bits, for finite x > 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Pair<V> logarithm_of(D d, V x) {
  const hn::RebindToSigned<D> di;
  const V one = hn::Set(d, 1.0), two = hn::Set(d, 2.0);
  const auto tiny = hn::Lt(x, hn::Set(d, 0x1p-1022));
  const auto bits = hn::BitCast(di, hn::IfThenElse(tiny, x * hn::Set(d, 0x1p54), x));
  const auto offset = bits - hn::Set(di, 0x3fe6a09e00000000);
  const auto exponent = hn::ShiftRight<52>(offset);
  const V fraction = hn::BitCast(d, bits - hn::ShiftLeft<52>(exponent));
  const V k = hn::BitCast(d, exponent + hn::Set(di, 0x4338000000000000)) - hn::Set(d, rounding_magic) -
              hn::IfThenElseZero(tiny, hn::Set(d, 54.0));

  const V f = fraction - one;
  const V u = two + f;
  const V u_low = f - (u - two);
  const V s = f / u;
  const auto product = exact_product(d, s, u);
  const V s_low = (((f - product.high) - product.low) - s * u_low) / u;
  const V z = s * s;
  const V tail = z * polynomial(d, z, hn::Set(d, 1.479819860511658591e-01), 1.531383769920937332e-01,
                                1.818357216161805012e-01, 2.222219843214978396e-01, 2.857142874366239149e-01,
                                3.999999999940941908e-01, 6.666666666666735130e-01);
  const V small_high = s + s;
  const V small_low = (s_low + s_low) + s * tail;
  const V large_high = k * hn::Set(d, 6.93147180369123816490e-01);
  const V high = large_high + small_high;
  const V virtual_part = high - large_high;
  const V error = (large_high - (high - virtual_part)) + (small_high - virtual_part);
  const V low = error + (small_low + k * hn::Set(d, 1.90821492927058770002e-10));
  const V sum = high + low;
  return {sum, low - (sum - high)};
}

/// x^y for x >= 0 finite and y finite; 0^0 = 1, 0^y = 0 or infinity.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V power_of(D d, V x, V y) {
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
  const auto is_zero = hn::Eq(x, zero);
  const auto log_x = logarithm_of(d, hn::IfThenElse(is_zero, one, x));
  // beyond 10^20 every base but 1 has overflowed or vanished
  const V limited = hn::Min(hn::Max(y, hn::Set(d, -1e20)), hn::Set(d, 1e20));
  const auto product = exact_product(d, log_x.high, limited);
  const V low = product.low + log_x.low * limited;
  const V value = exponential_of(d, product.high);
  const auto correctable = hn::Lt(hn::Abs(product.high), hn::Set(d, 760.0));
  const V result = hn::IfThenElse(correctable, value + value * low, value);
  const V at_zero = hn::IfThenElse(hn::Eq(y, zero), one, hn::IfThenElse(hn::Gt(y, zero), zero, one / zero));
  return hn::IfThenElse(is_zero, at_zero, result);
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

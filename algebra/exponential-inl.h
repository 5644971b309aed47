// The exponential of any bivector, over SIMD lanes, compiled once per instruction set.
//
// B^2 = S + Q with S scalar and Q = B^B, Q^2 = q scalar. exp B = cosh z + B sinh(z)/z with z^2 = S + Q, so
//   exp B = c0 + s2 Q + h B + g Q B.
// With l+- = (S +- D)/2, D^2 = S^2 - q, and C = cosh sqrt(l), N = sinh sqrt(l) / sqrt(l) (cos, sin for l < 0):
//   c0 = C+ C-,  s2 = N+ N- / 2,  h = (l+ N+ C- - l- C+ N-) / D,  g = (C+ N- - N+ C-) / (2 D).
// Where D is small beside S (nearly isoclinic) the same numbers come from the eigenvalues -X, -Y = S -+ sqrt(q) of B^2:
//   c0, h = means of cos, sinc and s2, g = their difference quotients over sqrt X, sqrt Y.
// (Dorst and Valkenburg 2011 give the split; these closed forms need no division by B^2.)

#if defined(DINI_ALGEBRA_EXPONENTIAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DINI_ALGEBRA_EXPONENTIAL_INL_H_
#undef DINI_ALGEBRA_EXPONENTIAL_INL_H_
#else
#define DINI_ALGEBRA_EXPONENTIAL_INL_H_
#endif

#include "algebra/elementary-inl.h"
#include "algebra/quaternion-inl.h"
#include "algebra/tolerance.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace dini::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// S and q of a bivector. Both are the same in every Euclidean frame; what is round-off counts as zero.
template <class V>
struct Squares {
  V S, q;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE Squares<V> squares_of(D d, const Bivector<V>& b) {
  const V two = hn::Set(d, 2.0);
  const V ee = b.e * b.e, ww = dot(b.W, b.W), am = two * dot(b.A, b.M);
  const V noise = hn::Set(d, tolerance::square_noise) * ((ee + ww) + hn::Abs(am));
  const V square = (ee - ww) - am;
  const Triple<V> y = b.e * b.W + cross(b.A, b.M);
  const V quad = hn::Set(d, 4.0) * (two * (dot(b.A, b.W) * dot(b.M, b.W)) - dot(y, y));
  return {hn::IfThenZeroElse(hn::Le(hn::Abs(square), noise), square),
          hn::IfThenZeroElse(hn::Le(hn::Abs(quad), noise * noise), quad)};
}

/// exp B = (c0 + s2 Q + h B + g Q B) cosh(hyperbolic).
template <class V>
struct Coefficients {
  V c0, s2, h, g, hyperbolic;
};

/// sin(x)/x from sin(x); x >= 0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V over_argument(D d, V value, V x) {
  return hn::IfThenElse(hn::Gt(x, hn::Zero(d)), value / x, hn::Set(d, 1.0));
}

/// C and N of l for the factor that may be hyperbolic, divided by cosh where it is.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void cosine_pair(D d, V l, V& C, V& N, V& hyperbolic) {
  const V one = hn::Set(d, 1.0);
  const auto real = hn::Gt(l, hn::Zero(d));
  const auto imaginary = hn::Lt(l, hn::Zero(d));
  const V root = hn::Sqrt(hn::Abs(l));
  C = one;
  N = one;
  hyperbolic = hn::IfThenElseZero(real, root);
  if (!hn::AllFalse(d, real)) N = hn::IfThenElse(real, tanh_of(d, root) / root, N);
  if (!hn::AllFalse(d, imaginary)) {
    const auto turn = sincos_of(d, root);
    C = hn::IfThenElse(imaginary, turn.cosine, C);
    N = hn::IfThenElse(imaginary, turn.sine / root, N);
  }
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE Coefficients<V> exact_coefficients(D d, const Squares<V>& squares) {
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0), half = hn::Set(d, 0.5);
  const V S = squares.S, q = squares.q;
  const V discriminant = hn::Sqrt(hn::Max(S * S - q, zero));
  const V large = half * (hn::Abs(S) + discriminant);
  const V small = hn::IfThenElseZero(hn::Gt(large, zero), hn::Set(d, 0.25) * q / large);
  const auto positive = hn::Ge(S, zero);
  const V l_plus = hn::IfThenElse(positive, large, zero - small);
  const V l_minus = hn::Min(hn::IfThenElse(positive, small, zero - large), zero);

  Coefficients<V> result;
  V C_plus, N_plus;
  cosine_pair(d, l_plus, C_plus, N_plus, result.hyperbolic);
  const V m = hn::Sqrt(zero - l_minus);
  V C_minus = one, N_minus = one;
  if (!hn::AllTrue(d, hn::Eq(m, zero))) {
    const auto turn = sincos_of(d, m);
    C_minus = turn.cosine;
    N_minus = over_argument(d, turn.sine, m);
  }
  result.c0 = C_plus * C_minus;
  result.s2 = half * N_plus * N_minus;
  // D = 0 leaves only the null generators, and the isoclinic ones below
  const auto split = hn::Gt(discriminant, zero);
  const V inverse = one / hn::IfThenElse(split, discriminant, one);
  const V N_mixed = N_plus * C_minus, C_mixed = C_plus * N_minus;
  result.h = hn::IfThenElse(split, (l_plus * N_mixed - l_minus * C_mixed) * inverse, one);
  result.g = hn::IfThenElse(split, half * (C_mixed - N_mixed) * inverse, hn::Set(d, 1.0 / 6));

  const auto isoclinic = hn::And(hn::Gt(q, zero), hn::Lt(discriminant, hn::Set(d, -0.25) * S));
  if (HWY_UNLIKELY(!hn::AllFalse(d, isoclinic))) {
    const V root = hn::Sqrt(hn::Max(q, zero));
    const V X = hn::IfThenElse(isoclinic, root - S, one);
    const V sigma = hn::Sqrt(X), delta = hn::IfThenElseZero(isoclinic, discriminant) / sigma;
    const auto sigma_turn = sincos_of(d, sigma), delta_turn = sincos_of(d, delta);
    const V sigma_sinc = over_argument(d, sigma_turn.sine, sigma),
            delta_sinc = over_argument(d, delta_turn.sine, delta);
    const V quotient = half / hn::IfThenElse(isoclinic, root, one);
    result.c0 = hn::IfThenElse(isoclinic, half * (sigma_turn.cosine + delta_turn.cosine), result.c0);
    result.h = hn::IfThenElse(isoclinic, half * (sigma_sinc + delta_sinc), result.h);
    result.s2 = hn::IfThenElse(isoclinic, (delta_turn.cosine - sigma_turn.cosine) * quotient, result.s2);
    result.g = hn::IfThenElse(isoclinic, (delta_sinc - sigma_sinc) * quotient, result.g);
  }
  return result;
}

/// "Boosted Surfaces", eq. (14): only the scalar part of the square counts.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Coefficients<V> paper_coefficients(D d, const Squares<V>& squares) {
  Coefficients<V> result;
  result.s2 = result.g = hn::Zero(d);
  cosine_pair(d, squares.S, result.c0, result.h, result.hyperbolic);
  return result;
}

/// The displacement of the origin by exp B, and the weight of its image: zero means infinity.
template <class V>
struct Image {
  Triple<V> numerator;
  V weight;
};

template <bool exact, class D, class V = hn::Vec<D>>
HWY_INLINE Image<V> image_of_origin(D d, const Bivector<V>& b, const Coefficients<V>& k) {
  const V two = hn::Set(d, 2.0), zero = hn::Zero(d);
  Quaternion<V> a{k.c0 - k.h * b.e, k.h * b.W};
  Quaternion<V> c{zero, k.h * b.M};  // half of the matrix entry
  if constexpr (exact) {
    const Triple<V> y = two * (b.e * b.W + cross(b.A, b.M));
    const V alpha = two * dot(b.A, b.W), beta = two * dot(b.M, b.W);
    a.s = a.s + k.g * dot(y, b.W);
    a.v = (a.v - k.s2 * y) + k.g * ((b.e * y + cross(y, b.W)) - (two * alpha) * b.M);
    c.s = k.g * (beta * b.e - dot(y, b.M)) - k.s2 * beta;
    c.v = c.v - k.g * (beta * b.W + cross(y, b.M));
  }
  return {two * vector_of_ratio(a, c), squared_size(a)};
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// Vectors, quaternions and bivectors over numbers or SIMD lanes, compiled once per instruction set.
//
// An even element of R(4,1) is a 2 x 2 matrix of quaternions s + v, where v stands for the bivector v.x e23 + v.y e31 +
// v.z e12:
//   V = [ a b ; c d ],  a = (s - e, W - y),  b = (-alpha, A),  c = (-2 beta, 2 M),  d = (s + e, W + y)
// for scalar s, bivector (A, W, e, M) = (no_e, e_e, no_ni, e_ni) and quad = dual of alpha no + y + beta ni
// (algebra/versor.h). The geometric product is the product of matrices; the reverse of [a b; c d] is [~d ~b; ~c ~a].
// The origin goes to vec(a ~c) / |a|^2 and infinity to vec(b ~d) / |b|^2: the first and the second column decide alone.

#if defined(DINI_ALGEBRA_QUATERNION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DINI_ALGEBRA_QUATERNION_INL_H_
#undef DINI_ALGEBRA_QUATERNION_INL_H_
#else
#define DINI_ALGEBRA_QUATERNION_INL_H_
#endif

#include "algebra/elements.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace dini::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class T>
struct Triple {
  T x, y, z;
};
template <class T>
HWY_INLINE Triple<T> operator+(const Triple<T>& a, const Triple<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
HWY_INLINE Triple<T> operator-(const Triple<T>& a, const Triple<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
HWY_INLINE Triple<T> operator*(T s, const Triple<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
HWY_INLINE T dot(const Triple<T>& a, const Triple<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
HWY_INLINE Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Triple<double> triple(const Vector& v) { return {v.x, v.y, v.z}; }
inline Triple<double> triple(const Point& p) { return {p.x, p.y, p.z}; }
inline Vector vector(const Triple<double>& t) { return {t.x, t.y, t.z}; }

template <class T>
struct Quaternion {
  T s;
  Triple<T> v;
};
template <class T>
HWY_INLINE Quaternion<T> operator+(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {a.s + b.s, a.v + b.v};
}
template <class T>
HWY_INLINE Quaternion<T> operator*(const Quaternion<T>& a, const Quaternion<T>& b) {
  return {a.s * b.s - dot(a.v, b.v), (a.s * b.v + b.s * a.v) - cross(a.v, b.v)};
}
template <class T>
HWY_INLINE T squared_size(const Quaternion<T>& a) {
  return a.s * a.s + dot(a.v, a.v);
}
/// The vector part of a ~c.
template <class T>
HWY_INLINE Triple<T> vector_of_ratio(const Quaternion<T>& a, const Quaternion<T>& c) {
  return (c.s * a.v - a.s * c.v) + cross(a.v, c.v);
}

/// A bivector: A on no^e, W on e^e, e on no^ni, M on e^ni.
template <class T>
struct Bivector {
  Triple<T> A, W;
  T e;
  Triple<T> M;
};
template <class T>
HWY_INLINE Bivector<T> operator*(T s, const Bivector<T>& b) {
  return {s * b.A, s * b.W, s * b.e, s * b.M};
}

inline Bivector<double> bivector(const Generator& g) {
  return {triple(g.no_e), triple(g.e_e), g.no_ni, triple(g.e_ni)};
}
inline Generator generator(const Bivector<double>& b) { return {vector(b.A), vector(b.W), b.e, vector(b.M)}; }

/// The bivector in coordinates whose origin is p; `half` is one half.
template <class T>
HWY_INLINE Bivector<T> seen_from(const Bivector<T>& b, const Triple<T>& p, T half) {
  const Triple<T> turn = cross(p, b.A);
  const T slope = dot(p, b.A);
  const Triple<T> mean_w = b.W - half * turn;
  const T mean_e = b.e - half * slope;
  return {b.A, b.W - turn, b.e - slope, (b.M - mean_e * p) + cross(mean_w, p)};
}

template <class T>
struct Matrix {
  Quaternion<T> a, b, c, d;
};

inline Matrix<double> matrix(const Versor& v) {
  const Generator& g = v.bivector;
  return {{v.scalar - g.no_ni, triple(g.e_e - v.quad.e)},
          {-v.quad.no, triple(g.no_e)},
          {-2 * v.quad.ni, triple(2 * g.e_ni)},
          {v.scalar + g.no_ni, triple(g.e_e + v.quad.e)}};
}
inline Versor versor(const Matrix<double>& m) {
  const Vector a = vector(m.a.v), d = vector(m.d.v);
  return {0.5 * (m.a.s + m.d.s),
          {vector(m.b.v), 0.5 * (a + d), 0.5 * (m.d.s - m.a.s), 0.5 * vector(m.c.v)},
          {-m.b.s, 0.5 * (d - a), -0.5 * m.c.s}};
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

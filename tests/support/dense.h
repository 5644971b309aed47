#pragma once

// The plainest possible R(4,1): 32 coefficients on the orthonormal blades of e1 e2 e3 e+ e- and a blade-by-blade
// product. Slow and obviously right; the fast formulas are held against it. no = (e- - e+)/2, ni = e- + e+.

#include <array>
#include <bit>
#include <cmath>

#include "algebra/elements.h"

namespace dini::dense {

template <class T>
struct Multivector {
  std::array<T, 32> c{};
};

template <class T>
Multivector<T> operator+(Multivector<T> a, const Multivector<T>& b) {
  for (std::size_t i = 0; i < 32; ++i) a.c[i] += b.c[i];
  return a;
}
template <class T>
Multivector<T> operator*(T s, Multivector<T> a) {
  for (T& value : a.c) value *= s;
  return a;
}

/// Sign of reordering blade a times blade b, with e- (bit 4) squaring to -1.
inline int product_sign(unsigned a, unsigned b) {
  int swaps = 0;
  for (unsigned rest = a >> 1; rest != 0; rest >>= 1) swaps += std::popcount(rest & b);
  const int metric = (a & b & 16u) != 0 ? -1 : 1;
  return swaps % 2 != 0 ? -metric : metric;
}

template <class T, class Keep>
Multivector<T> product_where(const Multivector<T>& a, const Multivector<T>& b, Keep keep) {
  Multivector<T> result;
  for (unsigned i = 0; i < 32; ++i) {
    for (unsigned j = 0; j < 32; ++j) {
      if (keep(i, j)) result.c[i ^ j] += static_cast<T>(product_sign(i, j)) * a.c[i] * b.c[j];
    }
  }
  return result;
}
template <class T>
Multivector<T> operator*(const Multivector<T>& a, const Multivector<T>& b) {
  return product_where(a, b, [](unsigned, unsigned) { return true; });
}
template <class T>
Multivector<T> operator^(const Multivector<T>& a, const Multivector<T>& b) {
  return product_where(a, b, [](unsigned i, unsigned j) { return (i & j) == 0; });
}

template <class T>
Multivector<T> reverse(Multivector<T> a) {
  for (unsigned i = 0; i < 32; ++i) {
    const int grade = std::popcount(i);
    if (grade * (grade - 1) / 2 % 2 != 0) a.c[i] = -a.c[i];
  }
  return a;
}

template <class T>
Multivector<T> grade(Multivector<T> a, int kept) {
  for (unsigned i = 0; i < 32; ++i) {
    if (std::popcount(i) != kept) a.c[i] = 0;
  }
  return a;
}

template <class T>
T largest(const Multivector<T>& a) {
  T result = 0;
  for (const T value : a.c) result = std::max(result, std::abs(value));
  return result;
}

template <class T>
Multivector<T> scalar(T value) {
  Multivector<T> result;
  result.c[0] = value;
  return result;
}

/// no * `no` + x e1 + y e2 + z e3 + ni * `ni`.
template <class T>
Multivector<T> vector(T no, T x, T y, T z, T ni) {
  Multivector<T> result;
  result.c[1] = x;
  result.c[2] = y;
  result.c[4] = z;
  result.c[8] = ni - no / 2;
  result.c[16] = ni + no / 2;
  return result;
}
template <class T>
Multivector<T> from(const Sphere& s) {
  return vector<T>(s.no, s.e.x, s.e.y, s.e.z, s.ni);
}
template <class T>
Multivector<T> point(T x, T y, T z) {
  return vector<T>(1, x, y, z, (x * x + y * y + z * z) / 2);
}

template <class T>
Multivector<T> from(const Generator& g) {
  const auto no = vector<T>(1, 0, 0, 0, 0), ni = vector<T>(0, 0, 0, 0, 1);
  const auto direction = [](const Vector& v) { return vector<T>(0, v.x, v.y, v.z, 0); };
  Multivector<T> result = (no ^ direction(g.no_e)) + (direction(g.e_ni) ^ ni) + (T(g.no_ni) * (no ^ ni));
  result.c[6] += g.e_e.x;  // e23
  result.c[5] -= g.e_e.y;  // e31
  result.c[3] += g.e_e.z;  // e12
  return result;
}

/// e1 e2 e3 (no ^ ni): the pseudoscalar that `Versor::quad` is divided by.
template <class T>
Multivector<T> pseudoscalar() {
  Multivector<T> e123;
  e123.c[7] = 1;
  return e123 * (vector<T>(1, 0, 0, 0, 0) ^ vector<T>(0, 0, 0, 0, 1));
}

template <class T>
Multivector<T> from(const Versor& v) {
  return scalar<T>(v.scalar) + from<T>(v.bivector) + from<T>(v.quad) * pseudoscalar<T>();
}

/// exp by 2^k squarings of a Taylor series; each square is rescaled when `projective`, so that nothing overflows.
template <class T>
Multivector<T> exponential(const Multivector<T>& b, bool projective = false) {
  int halvings = 0;
  T size = 32 * largest(b);
  for (; size > T(0.25); size /= 2) ++halvings;
  const Multivector<T> small = std::ldexp(T(1), -halvings) * b;
  Multivector<T> term = scalar<T>(1), sum = term;
  for (int k = 1; k < 24; ++k) {
    term = (T(1) / T(k)) * (term * small);
    sum = sum + term;
  }
  for (int k = 0; k < halvings; ++k) {
    sum = sum * sum;
    if (projective) sum = (1 / largest(sum)) * sum;
  }
  return sum;
}

/// The center of the grade-1 part of V x ~V.
template <class T>
std::array<T, 3> center(const Multivector<T>& round) {
  const T weight = round.c[16] - round.c[8];
  return {round.c[1] / weight, round.c[2] / weight, round.c[4] / weight};
}
template <class T>
std::array<T, 3> apply(const Multivector<T>& versor, T x, T y, T z) {
  return center(versor * point<T>(x, y, z) * reverse(versor));
}

}  // namespace dini::dense

#include "fitting/matrix.h"

#include <algorithm>
#include <cmath>

namespace dini::fitting {

std::optional<std::vector<double>> solve(SymmetricMatrix matrix, std::vector<double> right) {
  const std::size_t n = matrix.size();
  for (std::size_t j = 0; j < n; ++j) {
    double diagonal = matrix(j, j);
    for (std::size_t k = 0; k < j; ++k) diagonal -= matrix(j, k) * matrix(j, k);
    if (!(diagonal > 0)) return std::nullopt;
    matrix(j, j) = std::sqrt(diagonal);
    for (std::size_t i = j + 1; i < n; ++i) {
      double entry = matrix(i, j);
      for (std::size_t k = 0; k < j; ++k) entry -= matrix(i, k) * matrix(j, k);
      matrix(i, j) = entry / matrix(j, j);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) right[i] -= matrix(i, k) * right[k];
    right[i] /= matrix(i, i);
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) right[i] -= matrix(k, i) * right[k];
    right[i] /= matrix(i, i);
  }
  return right;
}

std::vector<EigenPair> eigen_pairs(SymmetricMatrix matrix) {
  const std::size_t n = matrix.size();
  constexpr int most_sweeps = 60;
  std::vector<EigenPair> pairs(n);
  for (std::size_t k = 0; k < n; ++k) {
    pairs[k].vector.assign(n, 0);
    pairs[k].vector[k] = 1;
  }
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    bool changed = false;
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t q = p + 1; q < n; ++q) {
        // What lies below the round-off of the diagonal changes nothing any more.
        if (std::abs(matrix(p, q)) <= 1e-17 * std::sqrt(std::abs(matrix(p, p) * matrix(q, q)))) continue;
        changed = true;
        const double ratio = (matrix(q, q) - matrix(p, p)) / (2 * matrix(p, q));
        const double tangent = (ratio < 0 ? -1 : 1) / (std::abs(ratio) + std::sqrt(1 + ratio * ratio));
        const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = tangent * cosine;
        for (std::size_t k = 0; k < n; ++k) {
          const double a = matrix(k, p), b = matrix(k, q);
          matrix(k, p) = cosine * a - sine * b;
          matrix(k, q) = sine * a + cosine * b;
        }
        for (std::size_t k = 0; k < n; ++k) {
          const double a = matrix(p, k), b = matrix(q, k);
          matrix(p, k) = cosine * a - sine * b;
          matrix(q, k) = sine * a + cosine * b;
          const double u = pairs[p].vector[k], v = pairs[q].vector[k];
          pairs[p].vector[k] = cosine * u - sine * v;
          pairs[q].vector[k] = sine * u + cosine * v;
        }
      }
    }
    if (!changed) break;
  }
  for (std::size_t k = 0; k < n; ++k) pairs[k].value = matrix(k, k);
  std::ranges::stable_sort(pairs, {}, &EigenPair::value);
  return pairs;
}

}  // namespace dini::fitting

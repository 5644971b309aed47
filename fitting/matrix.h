#pragma once

// Small symmetric matrices, row by row: as many rows as there are parameters.

#include <cstddef>
#include <optional>
#include <vector>

namespace dini::fitting {

class SymmetricMatrix {
 public:
  explicit SymmetricMatrix(std::size_t size) : size_(size), entries_(size * size) {}

  std::size_t size() const { return size_; }
  double& operator()(std::size_t row, std::size_t column) { return entries_[row * size_ + column]; }
  double operator()(std::size_t row, std::size_t column) const { return entries_[row * size_ + column]; }

 private:
  std::size_t size_;
  std::vector<double> entries_;
};

/// Solves `matrix * x = right` by Cholesky's method; nothing for a matrix that is not positive definite.
std::optional<std::vector<double>> solve(SymmetricMatrix matrix, std::vector<double> right);

/// An eigenvalue with its eigenvector of length 1.
struct EigenPair {
  double value = 0;
  std::vector<double> vector;
};

/// All of them, the smallest value first, by Jacobi's rotations.
std::vector<EigenPair> eigen_pairs(SymmetricMatrix matrix);

}  // namespace dini::fitting

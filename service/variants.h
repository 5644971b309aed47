#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "graph/problem.h"

namespace dini {

/// How a sweep is written: one of the three is an object or a list, the others are null.
struct SweepAxes {
  Json grid = nullptr;  ///< by parameter, the values to combine
  Json zip = nullptr;   ///< by parameter, lists of one length: the first values of all, then the second ones
  Json list = nullptr;  ///< objects of values by parameter
};

/// The settings of a sweep in their order. They are made when they are asked for, so a large grid takes no memory.
class Variants {
 public:
  /// Problems are in the request: none or several of the three, lists that are empty or differ in length, a parameter
  /// that is `fixed` as well, more than `most` variants.
  static Result<Variants> read(const SweepAxes& axes, const Json& fixed, std::size_t most);

  std::size_t size() const { return size_; }

  /// The values by parameter of one variant, without the fixed ones. In a grid the parameter whose name is the last in
  /// the alphabet varies fastest.
  Json at(std::size_t index) const;

 private:
  enum class Kind { grid, zip, list };

  Kind kind_ = Kind::list;
  Json values_;
  std::size_t size_ = 0;
};

}  // namespace dini

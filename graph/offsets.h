#pragma once

#include <cstddef>
#include <vector>

#include "geometry/axis.h"

namespace dini {

/// Where a value over `own` axes stands while a loop runs over `loop` axes: axes are matched by name, and an axis that
/// the value lacks has stride 0, so the value is constant along it.
class Offsets {
 public:
  Offsets() = default;
  Offsets(const Axes& own, const Axes& loop);

  bool constant() const { return constant_; }
  bool contiguous() const { return contiguous_; }  ///< offset equals the loop index

  /// The offset of the single loop index `index`.
  std::size_t at(std::size_t index) const;

  /// Offsets of the loop indices begin ... end - 1.
  void fill(std::size_t begin, std::size_t end, std::vector<std::size_t>& out) const;

 private:
  std::vector<std::size_t> sizes_;
  std::vector<std::size_t> strides_;
  bool constant_ = true;
  bool contiguous_ = false;
};

/// The stride of the axis called `name` in a value over `axes`; 0 when the value lacks it.
std::size_t stride_of(const Axes& axes, const std::string& name);

}  // namespace dini

#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace dini {

/// A named axis of a family: `size` samples, and whether the last sample joins the first.
/// A closed axis leaves out its end value and is welded when a mesh is made.
struct Axis {
  std::string name;
  std::size_t size = 1;
  bool closed = false;

  friend bool operator==(const Axis&, const Axis&) = default;
};

using Axes = std::vector<Axis>;

/// Number of values of a family over `axes`: the product of their sizes, saturating at the largest std::size_t.
std::size_t sample_count(const Axes& axes);

}  // namespace dini

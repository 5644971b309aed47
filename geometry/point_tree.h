#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algebra/kernels.h"
#include "geometry/cancel.h"

namespace dini {

/// Points in space, halved again and again along their widest extent, so that the nearest neighbors of one are found by
/// looking at few others. At most 2^32 - 1 finite points. A stopped one finds nothing right.
class PointTree {
 public:
  static constexpr std::size_t most_neighbors = 64;

  PointTree(kernels::ConstPoints points, std::size_t count, const Cancel& cancel);

  std::size_t size() const { return entries_.size(); }

  /// The indices of the points in an order in which near ones are near to one another.
  std::uint32_t in_order(std::size_t place) const { return entries_[place].index; }

  /// The points nearest to the one at `place` in that order, itself left out: nearest first, of equally near ones the
  /// smaller index first. At most `most_neighbors` are asked for; where there are fewer, the rest is the point itself.
  void find_nearest(std::size_t place, std::span<std::uint32_t> found) const;

 private:
  struct Entry {
    double at[3];
    std::uint32_t index;
  };
  struct Split {
    double value = 0;
    int axis = 0;
  };
  class Search;

  void split(std::size_t node, std::size_t begin, std::size_t end, const Cancel& cancel);

  std::vector<Entry> entries_;
  std::vector<Split> splits_;  ///< node n has the halves 2 n + 1 and 2 n + 2
};

}  // namespace dini

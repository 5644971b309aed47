#include "geometry/point_tree.h"

#include <algorithm>
#include <limits>
#include <tbb/parallel_invoke.h>

namespace dini {

namespace {

constexpr std::size_t leaf_size = 12;
constexpr std::size_t worth_a_thread = 4096;

}  // namespace

PointTree::PointTree(kernels::ConstPoints points, std::size_t count, const Cancel& cancel) : entries_(count) {
  for (std::size_t i = 0; i < count; ++i) {
    entries_[i] = {{points.x[i], points.y[i], points.z[i]}, static_cast<std::uint32_t>(i)};
  }
  std::size_t nodes = 1;
  for (std::size_t size = count; size > leaf_size; size = size - size / 2) nodes = 2 * nodes + 1;
  splits_.resize(nodes);
  split(0, 0, count, cancel);
}

void PointTree::split(std::size_t node, std::size_t begin, std::size_t end, const Cancel& cancel) {
  if (end - begin <= leaf_size || cancel.stopped()) return;
  double least[3], most[3];
  for (int k = 0; k < 3; ++k) least[k] = most[k] = entries_[begin].at[k];
  for (std::size_t i = begin + 1; i < end; ++i) {
    for (int k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], entries_[i].at[k]);
      most[k] = std::max(most[k], entries_[i].at[k]);
    }
  }
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (most[k] - least[k] > most[axis] - least[axis]) axis = k;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const auto entry = [&](std::size_t i) { return entries_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(entry(begin), entry(middle), entry(end), [axis](const Entry& a, const Entry& b) {
    return a.at[axis] < b.at[axis] || (a.at[axis] == b.at[axis] && a.index < b.index);
  });
  splits_[node] = {entries_[middle].at[axis], axis};
  const auto first = [&] { split(2 * node + 1, begin, middle, cancel); };
  const auto second = [&] { split(2 * node + 2, middle, end, cancel); };
  if (end - begin < worth_a_thread) {
    first();
    second();
  } else {
    tbb::parallel_invoke(first, second);
  }
}

/// The nearest points so far, in their order.
class PointTree::Search {
 public:
  Search(const PointTree& tree, std::size_t place, std::size_t wanted)
      : tree_(tree), self_(tree.entries_[place]), wanted_(wanted) {
    std::fill_n(squares_, wanted, std::numeric_limits<double>::infinity());
    std::fill_n(indices_, wanted, self_.index);
  }

  void look(std::size_t node, std::size_t begin, std::size_t end) {
    if (end - begin <= leaf_size) {
      for (std::size_t i = begin; i < end; ++i) take(tree_.entries_[i]);
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const Split& split = tree_.splits_[node];
    const double beyond = self_.at[split.axis] - split.value;
    if (beyond < 0) {
      look(2 * node + 1, begin, middle);
      if (beyond * beyond <= squares_[wanted_ - 1]) look(2 * node + 2, middle, end);
    } else {
      look(2 * node + 2, middle, end);
      if (beyond * beyond <= squares_[wanted_ - 1]) look(2 * node + 1, begin, middle);
    }
  }

  const std::uint32_t* indices() const { return indices_; }

 private:
  void take(const Entry& entry) {
    const double x = entry.at[0] - self_.at[0], y = entry.at[1] - self_.at[1], z = entry.at[2] - self_.at[2];
    const double square = x * x + y * y + z * z;
    if (square > squares_[wanted_ - 1] || entry.index == self_.index) return;
    std::size_t k = wanted_ - 1;
    if (square == squares_[k] && entry.index > indices_[k]) return;
    for (; k > 0 && (square < squares_[k - 1] || (square == squares_[k - 1] && entry.index < indices_[k - 1])); --k) {
      squares_[k] = squares_[k - 1];
      indices_[k] = indices_[k - 1];
    }
    squares_[k] = square;
    indices_[k] = entry.index;
  }

  const PointTree& tree_;
  const Entry& self_;
  std::size_t wanted_;
  double squares_[most_neighbors];
  std::uint32_t indices_[most_neighbors];
};

void PointTree::find_nearest(std::size_t place, std::span<std::uint32_t> found) const {
  const std::size_t wanted = std::min(found.size(), most_neighbors);
  if (wanted == 0) return;
  Search search(*this, place, wanted);
  search.look(0, 0, entries_.size());
  std::copy_n(search.indices(), wanted, found.begin());
}

}  // namespace dini

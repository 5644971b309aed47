#pragma once

#include <vector>

#include "draco/corner_table.h"

namespace dini {

/// A walk from triangle to triangle that meets each once, and comes back to branches that were left for later: what
/// edgebreaker and the order of vertices have in common.
class TriangleWalk {
 public:
  explicit TriangleWalk(std::size_t triangles) : done_(triangles, false) {}

  /// Whether the triangle of a corner was met; one that there is not counts as met.
  bool is_done(Corner corner) const { return corner == absent || done_[corner / 3]; }
  void mark(Corner corner) { done_[corner / 3] = true; }

  /// Follows the branch that begins at `start`, and those that it splits into, last come first. `follow` is given the
  /// corner where a branch begins; it goes on until it calls `end` or `split`.
  template <class Follow>
  void from(Corner start, const Follow& follow) {
    branches_.assign(1, start);
    while (!branches_.empty()) {
      const Corner corner = branches_.back();
      if (is_done(corner)) {
        branches_.pop_back();
      } else {
        follow(corner);
      }
    }
  }

  void end() { branches_.pop_back(); }
  void split(Corner later, Corner now) {
    branches_.back() = later;
    branches_.push_back(now);
  }

 private:
  std::vector<bool> done_;
  std::vector<Corner> branches_;
};

}  // namespace dini

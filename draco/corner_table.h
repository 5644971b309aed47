#pragma once

// Triangles by their corners: corner 3 t + k is the k-th corner of triangle t.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace dini {

using Corner = std::uint32_t;

/// Stands for a corner, a vertex or a number that there is not.
inline constexpr std::uint32_t absent = std::numeric_limits<std::uint32_t>::max();

inline Corner next(Corner corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
inline Corner previous(Corner corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

/// Which corners of a mesh are opposite to each other across an edge. Only for manifolds: each edge has one triangle on
/// either side at most, neighbors turn the same way around and differ in a vertex, and the triangles of a vertex are
/// one fan.
class CornerTable {
 public:
  /// The table of triangles with three different vertices below `vertices`, each of which is used; nothing when they
  /// are no manifold. Takes time in proportion to the triangles, and a logarithm of the largest fan.
  static std::optional<CornerTable> of(std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t vertices);

  std::size_t corners() const { return opposites_.size(); }
  std::size_t triangles() const { return opposites_.size() / 3; }
  std::size_t vertices() const { return boundary_.size(); }

  std::uint32_t vertex(Corner corner) const { return triangles_[corner / 3][corner % 3]; }

  /// The corner across the edge that `corner` faces; absent at a boundary.
  Corner opposite(Corner corner) const { return opposites_[corner]; }

  /// The corner across the edge on the right of `corner`, seen with its own vertex ahead; absent at a boundary.
  Corner right(Corner corner) const { return opposite(next(corner)); }
  Corner left(Corner corner) const { return opposite(previous(corner)); }

  bool on_boundary(std::uint32_t vertex) const { return boundary_[vertex]; }

 private:
  explicit CornerTable(std::span<const std::array<std::uint32_t, 3>> triangles) : triangles_(triangles) {}
  bool pair_corners(std::size_t vertices);
  bool fans_are_whole(std::size_t vertices);

  std::span<const std::array<std::uint32_t, 3>> triangles_;
  std::vector<Corner> opposites_;
  std::vector<bool> boundary_;
};

}  // namespace dini

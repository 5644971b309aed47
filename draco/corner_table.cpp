#include "draco/corner_table.h"

#include <algorithm>

namespace dini {
namespace {

/// A directed edge by where it ends, and the corner that faces it.
struct Edge {
  std::uint32_t end = 0;
  Corner corner = 0;
  friend bool operator<(const Edge& a, const Edge& b) { return a.end < b.end; }
};

}  // namespace

std::optional<CornerTable> CornerTable::of(std::span<const std::array<std::uint32_t, 3>> triangles,
                                           std::size_t vertices) {
  CornerTable table(triangles);
  if (!table.pair_corners(vertices) || !table.fans_are_whole(vertices)) return std::nullopt;
  return table;
}

// Edges are sorted by where they begin, then by where they end; the same edge in the other direction is its other side.
bool CornerTable::pair_corners(std::size_t vertices) {
  const auto corners = static_cast<Corner>(3 * triangles_.size());
  std::vector<std::uint32_t> begins(vertices + 2, 0);
  for (Corner corner = 0; corner < corners; ++corner) ++begins[vertex(next(corner)) + 2];
  for (std::size_t i = 2; i < begins.size(); ++i) begins[i] += begins[i - 1];
  std::vector<Edge> edges(corners);
  for (Corner corner = 0; corner < corners; ++corner) {
    edges[begins[vertex(next(corner)) + 1]++] = {vertex(previous(corner)), corner};
  }
  const auto edges_of = [&](std::uint32_t vertex) {
    return std::span(edges).subspan(begins[vertex], begins[vertex + 1] - begins[vertex]);
  };
  for (std::uint32_t vertex = 0; vertex < vertices; ++vertex) {
    const auto own = edges_of(vertex);
    std::sort(own.begin(), own.end());
    const auto same = [](const Edge& a, const Edge& b) { return a.end == b.end; };
    if (std::adjacent_find(own.begin(), own.end(), same) != own.end()) return false;
  }
  opposites_.assign(corners, absent);
  for (std::uint32_t begin = 0; begin < vertices; ++begin) {
    for (const Edge& edge : edges_of(begin)) {
      if (edge.end == begin) return false;  // a triangle that has a vertex twice
      const auto others = edges_of(edge.end);
      const auto other = std::lower_bound(others.begin(), others.end(), Edge{begin, 0});
      if (other == others.end() || other->end != begin) continue;
      if (vertex(other->corner) == vertex(edge.corner)) return false;  // two sides of one triangle
      opposites_[edge.corner] = other->corner;
    }
  }
  return true;
}

// Turns around each vertex from the boundary, if it has one, and counts what it meets.
bool CornerTable::fans_are_whole(std::size_t vertices) {
  std::vector<std::uint32_t> counts(vertices, 0);
  std::vector<Corner> firsts(vertices, absent);
  boundary_.assign(vertices, false);
  for (Corner corner = 0; corner < corners(); ++corner) {
    const std::uint32_t around = vertex(corner);
    ++counts[around];
    const bool begins_fan = right(corner) == absent;
    if (begins_fan && boundary_[around]) return false;
    if (begins_fan || firsts[around] == absent) firsts[around] = corner;
    if (begins_fan) boundary_[around] = true;
  }
  for (std::uint32_t around = 0; around < vertices; ++around) {
    if (firsts[around] == absent) return false;  // a vertex of no triangle
    std::uint32_t met = 0;
    Corner corner = firsts[around];
    do {
      ++met;
      const Corner across = left(corner);
      corner = across == absent ? absent : previous(across);
    } while (corner != absent && corner != firsts[around]);
    if (met != counts[around]) return false;
  }
  return true;
}

}  // namespace dini

#include "geometry/welded_mesh.h"

#include <algorithm>

#include "geometry/chunks.h"
#include "geometry/weld.h"

namespace dini {

WeldedMesh welded(const Mesh& mesh, const Cancel& cancel) {
  WeldedMesh result;
  const std::vector<std::uint32_t> labels = position_labels(mesh.positions, cancel);
  std::vector<std::uint32_t> vertex_at(labels.size(), none_of_them);  // by label
  CancelEvery steps(cancel);
  result.triangles.reserve(mesh.triangles.size());
  for (const auto& [i, j, k] : mesh.triangles) {
    if (steps.stopped()) return {};
    const std::uint32_t a = labels[i], b = labels[j], c = labels[k];
    if (a == b || b == c || c == a) continue;
    result.triangles.push_back({a, b, c});
    vertex_at[a] = vertex_at[b] = vertex_at[c] = 0;
  }
  std::uint32_t count = 0;
  for (std::uint32_t& vertex : vertex_at) {
    if (vertex == 0) vertex = count++;
  }
  result.positions.resize(count);
  result.vertex_of.resize(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (steps.stopped()) return {};
    result.vertex_of[i] = vertex_at[labels[i]];
    if (labels[i] == i && result.vertex_of[i] != none_of_them) {
      result.positions[result.vertex_of[i]] = to_vector(mesh.positions[i]);
    }
  }
  for (Corners& corners : result.triangles) {
    for (std::uint32_t& corner : corners) corner = vertex_at[corner];
  }
  return result;
}

MeshSides sides_of(const std::vector<Corners>& triangles, std::size_t vertices, const Cancel& cancel) {
  const std::size_t count = 3 * triangles.size();
  MeshSides result;
  result.opposite.assign(count, none_of_them);
  std::vector<std::size_t> ends(vertices + 1);
  const auto lower = [&](std::uint32_t side) { return std::min(start_of(triangles, side), end_of(triangles, side)); };
  const auto higher = [&](std::uint32_t side) { return std::max(start_of(triangles, side), end_of(triangles, side)); };
  CancelEvery steps(cancel);
  // By their lower corner first, a counting sort, then each short run by the higher one.
  for (std::uint32_t side = 0; side < count && !steps.stopped(); ++side) ++ends[lower(side) + 1];
  for (std::size_t i = 1; i <= vertices; ++i) ends[i] += ends[i - 1];
  std::vector<std::uint32_t> sorted(count);
  for (std::uint32_t side = 0; side < count && !steps.stopped(); ++side) sorted[ends[lower(side)]++] = side;
  for (std::size_t vertex = 0; vertex < vertices && !steps.stopped(); ++vertex) {
    std::size_t begin = vertex == 0 ? 0 : ends[vertex - 1];
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(begin),
              sorted.begin() + static_cast<std::ptrdiff_t>(ends[vertex]),
              [&](std::uint32_t a, std::uint32_t b) { return higher(a) != higher(b) ? higher(a) < higher(b) : a < b; });
    while (begin < ends[vertex] && !steps.stopped()) {
      const std::size_t first = begin;
      while (begin < ends[vertex] && higher(sorted[begin]) == higher(sorted[first])) ++begin;
      ++result.edges;
      const std::uint32_t a = sorted[first];
      if (begin - first == 1) {
        result.borders.push_back(a);
      } else if (begin - first == 2 && start_of(triangles, a) == end_of(triangles, sorted[first + 1])) {
        result.opposite[a] = sorted[first + 1];
        result.opposite[sorted[first + 1]] = a;
      } else {
        result.faults.insert(result.faults.end(), sorted.begin() + static_cast<std::ptrdiff_t>(first),
                             sorted.begin() + static_cast<std::ptrdiff_t>(begin));
      }
    }
  }
  std::sort(result.borders.begin(), result.borders.end());
  std::sort(result.faults.begin(), result.faults.end());
  return result;
}

BorderLoops border_loops(const WeldedMesh& mesh, const MeshSides& sides, const Cancel& cancel) {
  BorderLoops result;
  std::vector<std::uint32_t> leaving(mesh.positions.size(), none_of_them);  // the border side that begins at a vertex
  CancelEvery steps(cancel);
  for (const std::uint32_t side : sides.borders) {
    if (steps.stopped()) return result;
    std::uint32_t& known = leaving[start_of(mesh.triangles, side)];
    if (known != none_of_them) {
      result.pinched = start_of(mesh.triangles, side);
      return result;
    }
    known = side;
  }
  for (const std::uint32_t first : sides.borders) {
    if (leaving[start_of(mesh.triangles, first)] == none_of_them) continue;
    std::vector<std::uint32_t> loop;
    // At a fault a border may end, so that its loop stays open.
    for (std::uint32_t side = first; side != none_of_them && !steps.stopped();) {
      loop.push_back(side);
      leaving[start_of(mesh.triangles, side)] = none_of_them;
      side = leaving[end_of(mesh.triangles, side)];
    }
    result.loops.push_back(std::move(loop));
  }
  return result;
}

}  // namespace dini

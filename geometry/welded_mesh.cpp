#include "geometry/welded_mesh.h"

#include <algorithm>

#include "geometry/chunks.h"
#include "geometry/place_text.h"
#include "geometry/weld.h"
#include "geometry/zeroed.h"

namespace dini {

WeldedMesh welded(const Mesh& mesh, const Cancel& cancel) {
  WeldedMesh result;
  const std::vector<std::uint32_t> labels = position_labels(mesh.positions, cancel);
  if (cancel.stopped()) return {};
  // By label: 0 where no triangle uses it, else one more than the number that it gets.
  Zeroed<std::uint32_t> number(labels.size());
  CancelEvery steps(cancel);
  result.triangles.reserve(mesh.triangles.size());
  for (const auto& [i, j, k] : mesh.triangles) {
    if (steps.stopped()) return {};
    const std::uint32_t a = labels[i], b = labels[j], c = labels[k];
    if (a == b || b == c || c == a) continue;
    result.triangles.push_back({a, b, c});
    number[a] = number[b] = number[c] = 1;
  }
  result.vertex_of.reserve(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (steps.stopped()) return {};
    if (labels[i] == i && number[i] != 0) {
      result.positions.push_back(to_vector(mesh.positions[i]));
      number[i] = static_cast<std::uint32_t>(result.positions.size());
    }
    result.vertex_of.push_back(number[labels[i]] - 1);
  }
  for (Corners& corners : result.triangles) {
    if (steps.stopped()) return {};
    for (std::uint32_t& corner : corners) corner = number[corner] - 1;
  }
  return result;
}

std::vector<std::size_t> first_vertices(const WeldedMesh& mesh, const Cancel& cancel) {
  std::vector<std::size_t> first;
  first.reserve(mesh.positions.size());
  CancelEvery steps(cancel);
  for (std::size_t i = 0; i < mesh.vertex_of.size() && !steps.stopped(); ++i) {
    // Positions are numbered as their first vertices follow one another.
    if (mesh.vertex_of[i] == first.size()) first.push_back(i);
  }
  return first;
}

MeshSides sides_of(const std::vector<Corners>& triangles, std::size_t vertices, const Cancel& cancel) {
  const std::size_t count = 3 * triangles.size();
  MeshSides result;
  Zeroed<std::size_t> ends(vertices + 1);
  const auto lower = [&](std::uint32_t side) { return std::min(start_of(triangles, side), end_of(triangles, side)); };
  const auto higher = [&](std::uint32_t side) { return std::max(start_of(triangles, side), end_of(triangles, side)); };
  CancelEvery steps(cancel);
  // By their lower corner first, a counting sort, then each short run by the higher one.
  for (std::uint32_t side = 0; side < count && !steps.stopped(); ++side) ++ends[lower(side) + 1];
  for (std::size_t i = 1; i <= vertices && !steps.stopped(); ++i) ends[i] += ends[i - 1];
  auto sorted = Zeroed<std::uint32_t>::unwritten(count);
  for (std::uint32_t side = 0; side < count && !steps.stopped(); ++side) sorted[ends[lower(side)]++] = side;
  if (cancel.stopped()) return result;
  for (std::size_t vertex = 0; vertex < vertices && !steps.stopped(); ++vertex) {
    std::size_t begin = vertex == 0 ? 0 : ends[vertex - 1];
    std::sort(sorted.data() + begin, sorted.data() + ends[vertex],
              [&](std::uint32_t a, std::uint32_t b) { return higher(a) != higher(b) ? higher(a) < higher(b) : a < b; });
    while (begin < ends[vertex] && !steps.stopped()) {
      const std::size_t first = begin;
      while (begin < ends[vertex] && higher(sorted[begin]) == higher(sorted[first])) ++begin;
      const std::uint32_t a = sorted[first];
      if (begin - first == 1) {
        result.borders.push_back(a);
      } else if (begin - first != 2 || start_of(triangles, a) != end_of(triangles, sorted[first + 1])) {
        result.faults.insert(result.faults.end(), sorted.data() + first, sorted.data() + begin);
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

std::optional<std::string> fault_of(const WeldedMesh& mesh, const MeshSides& sides, const BorderLoops& borders) {
  if (!sides.faults.empty()) {
    const std::uint32_t side = sides.faults.front();
    return "the edge from " + place_text(mesh.positions[start_of(mesh.triangles, side)]) + " to " +
           place_text(mesh.positions[end_of(mesh.triangles, side)]) +
           " has more than two triangles, or two that run along it the same way";
  }
  if (borders.pinched) return "borders meet in the vertex at " + place_text(mesh.positions[*borders.pinched]);
  return std::nullopt;
}

}  // namespace dini

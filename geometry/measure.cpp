#include "geometry/measure.h"

#include <algorithm>
#include <atomic>

#include "geometry/bounding_box.h"
#include "geometry/compensated_sum.h"
#include "geometry/corner.h"
#include "geometry/in_order.h"
#include "geometry/weld.h"

namespace dini {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The triangles with welded corners, without those that welding makes flat.
std::vector<Triangle> welded_triangles(const Mesh& mesh, const std::vector<std::uint32_t>& labels, CancelEvery& steps) {
  std::vector<Triangle> welded;
  welded.reserve(mesh.triangles.size());
  for (const auto& [i, j, k] : mesh.triangles) {
    if (steps.stopped()) break;
    const std::uint32_t a = labels[i], b = labels[j], c = labels[k];
    if (a != b && b != c && c != a) welded.push_back({a, b, c});
  }
  return welded;
}

void measure_bounds(const Mesh& mesh, const std::vector<Triangle>& triangles, Measures& measures, CancelEvery& steps) {
  std::vector<bool> used(mesh.positions.size());
  BoundingBox bounds;
  for (const Triangle& triangle : triangles) {
    if (steps.stopped()) return;
    for (const std::uint32_t corner : triangle) {
      if (used[corner]) continue;
      used[corner] = true;
      ++measures.vertices;
      bounds.add(to_vector(mesh.positions[corner]));
    }
  }
  measures.minimum = to_point(bounds.low);
  measures.maximum = to_point(bounds.high);
  measures.diagonal = length(bounds.high - bounds.low);
}

void measure_sums(const Mesh& mesh, const std::vector<Triangle>& triangles, Measures& measures, const Cancel& cancel) {
  const Vector middle = to_vector(measures.minimum) + 0.5 * (to_vector(measures.maximum) - to_vector(measures.minimum));
  CompensatedSum area, volume;
  compute_in_order<std::array<double, 2>>(
      cancel, triangles.size(),
      [&](std::size_t i) -> std::array<double, 2> {
        const std::array<Vector, 3> corners = corners_of(mesh, triangles[i]);
        const Vector normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
        return {std::sqrt(squared_length(normal)) / 2, dot(corners[0] - middle, normal) / 6};
      },
      [&](std::size_t, const std::array<double, 2>& terms) {
        area.add(terms[0]);
        volume.add(terms[1]);
      });
  measures.area = area.value();
  measures.volume = volume.value();
}

/// Calls body(lower, higher, upward) for the three sides of a triangle; `upward` when it runs from lower to higher.
template <class Body>
void for_each_side(const Triangle& triangle, Body body) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
    body(std::min(from, to), std::max(from, to), from < to);
  }
}

/// Sorts the sides at one vertex, of which a fan may have millions: in short runs that are merged, with looks at the
/// flag between them. Stopped early: not sorted.
void sort_sides(std::uint64_t* begin, std::uint64_t* end, const Cancel& cancel) {
  constexpr std::ptrdiff_t run = std::ptrdiff_t{1} << 16;
  const std::ptrdiff_t size = end - begin;
  for (std::ptrdiff_t from = 0; from < size && (from == 0 || !cancel.stopped()); from += run) {
    std::sort(begin + from, begin + std::min(from + run, size));
  }
  for (std::ptrdiff_t sorted = run; sorted < size; sorted *= 2) {
    for (std::ptrdiff_t from = 0; from + sorted < size && !cancel.stopped(); from += 2 * sorted) {
      std::inplace_merge(begin + from, begin + from + sorted, begin + std::min(from + 2 * sorted, size));
    }
  }
}

/// Counts edges by sorting sides by their lower corner first (a counting sort), then each short run by the higher one.
void measure_edges(const std::vector<Triangle>& triangles, std::size_t vertices, Measures& measures,
                   const Cancel& cancel) {
  CancelEvery steps(cancel);
  Zeroed<std::size_t> run_ends(vertices + 1);
  for (const Triangle& triangle : triangles) {
    if (steps.stopped()) return;
    for_each_side(triangle, [&](std::uint32_t lower, std::uint32_t, bool) { ++run_ends[lower + 1]; });
  }
  for (std::size_t i = 1; i <= vertices && !steps.stopped(); ++i) run_ends[i] += run_ends[i - 1];
  Zeroed<std::uint64_t> sides(3 * triangles.size());
  for (const Triangle& triangle : triangles) {
    if (steps.stopped()) return;
    for_each_side(triangle, [&](std::uint32_t lower, std::uint32_t higher, bool upward) {
      sides[run_ends[lower]++] = 2 * std::uint64_t{higher} + (upward ? 1 : 0);
    });
  }
  std::atomic<std::size_t> edges = 0, boundary_edges = 0, unpaired = 0;
  for_chunks(cancel, vertices, [&](std::size_t first_vertex, std::size_t last_vertex) {
    std::size_t found = 0, alone = 0, wrong = 0;
    for (std::size_t vertex = first_vertex; vertex < last_vertex; ++vertex) {
      // Filling moved every run's start to its end.
      std::size_t begin = vertex == 0 ? 0 : run_ends[vertex - 1];
      const std::size_t end = run_ends[vertex];
      sort_sides(sides.data() + begin, sides.data() + end, cancel);
      while (begin < end) {
        const std::size_t first = begin;
        while (begin < end && sides[begin] / 2 == sides[first] / 2) ++begin;
        ++found;
        if (begin - first == 1) ++alone;
        if (begin - first != 2 || sides[first] == sides[first + 1]) ++wrong;
      }
    }
    edges += found;
    boundary_edges += alone;
    unpaired += wrong;
  });
  measures.edges = edges;
  measures.boundary_edges = boundary_edges;
  measures.closed = unpaired == 0;
}

}  // namespace

Measures measure(const Mesh& mesh, const Cancel& cancel) {
  Measures measures;
  CancelEvery steps(cancel);
  const std::vector<Triangle> triangles = welded_triangles(mesh, position_labels(mesh.positions, cancel), steps);
  if (triangles.empty()) return measures;
  measures.triangles = triangles.size();
  measure_bounds(mesh, triangles, measures, steps);
  measure_sums(mesh, triangles, measures, cancel);
  measure_edges(triangles, mesh.positions.size(), measures, cancel);
  measures.euler = static_cast<long long>(measures.vertices) - static_cast<long long>(measures.edges) +
                   static_cast<long long>(measures.triangles);
  return measures;
}

}  // namespace dini

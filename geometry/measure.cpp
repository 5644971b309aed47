#include "geometry/measure.h"

#include <algorithm>
#include <limits>

#include "geometry/corner.h"
#include "geometry/weld.h"

namespace dini {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Neumaier's compensated sum: the error does not grow with the number of terms.
class Sum {
 public:
  void add(double term) {
    const double total = total_ + term;
    lost_ += std::abs(total_) >= std::abs(term) ? (total_ - total) + term : (term - total) + total_;
    total_ = total;
  }
  double value() const { return total_ + lost_; }

 private:
  double total_ = 0, lost_ = 0;
};

/// The triangles with welded corners, without those that welding makes flat.
std::vector<Triangle> welded_triangles(const Mesh& mesh, const std::vector<std::uint32_t>& labels) {
  std::vector<Triangle> welded;
  welded.reserve(mesh.triangles.size());
  for (const auto& [i, j, k] : mesh.triangles) {
    const std::uint32_t a = labels[i], b = labels[j], c = labels[k];
    if (a != b && b != c && c != a) welded.push_back({a, b, c});
  }
  return welded;
}

void measure_bounds(const Mesh& mesh, const std::vector<Triangle>& triangles, Measures& measures) {
  std::vector<bool> used(mesh.positions.size());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point low{infinity, infinity, infinity};
  Point high{-infinity, -infinity, -infinity};
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t corner : triangle) {
      if (used[corner]) continue;
      used[corner] = true;
      ++measures.vertices;
      const Point p = mesh.positions[corner];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  measures.minimum = low;
  measures.maximum = high;
  measures.diagonal = length(to_vector(high) - to_vector(low));
}

void measure_sums(const Mesh& mesh, const std::vector<Triangle>& triangles, Measures& measures, const Cancel& cancel) {
  const Vector middle = to_vector(measures.minimum) + 0.5 * (to_vector(measures.maximum) - to_vector(measures.minimum));
  Sum area, volume;
  CancelEvery steps(cancel);
  for (const Triangle& triangle : triangles) {
    if (steps.stopped()) return;
    const std::array<Vector, 3> corners = corners_of(mesh, triangle);
    const Vector normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    area.add(std::sqrt(squared_length(normal)) / 2);
    volume.add(dot(corners[0] - middle, normal) / 6);
  }
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

/// Counts edges by sorting sides by their lower corner first (a counting sort), then each short run by the higher one.
void measure_edges(const std::vector<Triangle>& triangles, std::size_t vertices, Measures& measures,
                   const Cancel& cancel) {
  std::vector<std::size_t> run_ends(vertices + 1);
  for (const Triangle& triangle : triangles) {
    for_each_side(triangle, [&](std::uint32_t lower, std::uint32_t, bool) { ++run_ends[lower + 1]; });
  }
  for (std::size_t i = 1; i <= vertices; ++i) run_ends[i] += run_ends[i - 1];
  std::vector<std::uint64_t> sides(3 * triangles.size());
  for (const Triangle& triangle : triangles) {
    for_each_side(triangle, [&](std::uint32_t lower, std::uint32_t higher, bool upward) {
      sides[run_ends[lower]++] = 2 * std::uint64_t{higher} + (upward ? 1 : 0);
    });
  }
  bool paired = true;
  std::size_t begin = 0;
  CancelEvery steps(cancel);
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
    if (steps.stopped()) return;
    const std::size_t end = run_ends[vertex];  // filling moved every run's start to its end
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin), sides.begin() + static_cast<std::ptrdiff_t>(end));
    while (begin < end) {
      const std::size_t first = begin;
      while (begin < end && sides[begin] / 2 == sides[first] / 2) ++begin;
      ++measures.edges;
      if (begin - first == 1) ++measures.boundary_edges;
      paired = paired && begin - first == 2 && sides[first] != sides[first + 1];
    }
  }
  measures.closed = paired;
}

}  // namespace

Measures measure(const Mesh& mesh, const Cancel& cancel) {
  Measures measures;
  const std::vector<Triangle> triangles = welded_triangles(mesh, position_labels(mesh.positions, cancel));
  if (triangles.empty()) return measures;
  measures.triangles = triangles.size();
  measure_bounds(mesh, triangles, measures);
  measure_sums(mesh, triangles, measures, cancel);
  measure_edges(triangles, mesh.positions.size(), measures, cancel);
  measures.euler = static_cast<long long>(measures.vertices) - static_cast<long long>(measures.edges) +
                   static_cast<long long>(measures.triangles);
  return measures;
}

}  // namespace dini

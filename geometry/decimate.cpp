#include "geometry/decimate.h"

#include <algorithm>
#include <cmath>

#include "geometry/number_table.h"
#include "geometry/zeroed.h"

namespace dini {

namespace {

constexpr std::size_t finest = 1024;  ///< cells along the longest side of the box around the mesh

/// The box around all vertices, as the cube that cells are cut from.
struct Cube {
  std::array<double, 3> corner{};
  double side = 0;

  Cube(const Column<Point>& points, CancelEvery& steps) {
    for (std::size_t k = 0; k < 3 && !points.empty(); ++k) {
      const double* values = points.component(k);
      double least = values[0], most = values[0];
      for (std::size_t i = 0; i < points.size() && !steps.stopped(); ++i) {
        least = std::min(least, values[i]);
        most = std::max(most, values[i]);
      }
      corner[k] = least;
      side = std::max(side, most - least);
    }
  }

  /// The cell of a point, of `cells` along each side.
  std::uint64_t cell_of(const Point& point, std::size_t cells) const {
    const std::array<double, 3> place = {point.x, point.y, point.z};
    std::uint64_t cell = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double share = side > 0 ? (place[k] - corner[k]) / side : 0;
      const auto index = static_cast<std::size_t>(share * static_cast<double>(cells));
      cell = cell * finest + std::min(index, cells - 1);
    }
    return cell;
  }
};

/// The cells of all vertices, and what is left of the triangles in them.
class Clustering {
 public:
  Clustering(const Mesh& mesh, const Cube& cube, std::size_t cells, const Cancel& cancel)
      : mesh_(mesh), cell_of_(mesh.positions.size()) {
    CancelEvery steps(cancel);
    for (std::size_t i = 0; i < cell_of_.size() && !steps.stopped(); ++i) {
      cell_of_[i] = cube.cell_of(mesh.positions[i], cells);
    }
    for (const auto& triangle : mesh.triangles) {
      if (steps.stopped()) break;
      triangles_ += stays(triangle) ? 1 : 0;
    }
  }

  /// Triangles whose corners are in three cells.
  std::size_t triangles() const { return triangles_; }

  bool stays(const std::array<std::uint32_t, 3>& triangle) const {
    const std::uint64_t a = cell_of_[triangle[0]], b = cell_of_[triangle[1]], c = cell_of_[triangle[2]];
    return a != b && b != c && c != a;
  }

  Mesh mesh(const Cancel& cancel) const {
    Mesh coarse;
    coarse.color = mesh_.color;
    coarse.finish = mesh_.finish;
    std::vector<std::uint32_t> kept;  // the vertices that stand for their cells
    NumberTable vertex_of;            // by cell
    CancelEvery steps(cancel);
    for (const auto& triangle : mesh_.triangles) {
      if (steps.stopped()) break;
      if (!stays(triangle)) continue;
      auto& target = coarse.triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const auto fresh = static_cast<std::uint32_t>(kept.size());
        const auto [vertex, is_first] = vertex_of.try_emplace(cell_of_[triangle[k]], fresh, cancel);
        if (is_first) kept.push_back(triangle[k]);
        target[k] = vertex;
      }
    }
    coarse.positions = of_kept(*mesh_.positions, kept);
    coarse.normals = of_kept(*mesh_.normals, kept);
    for (const std::uint32_t vertex : kept) {
      if (!mesh_.uvs.empty()) coarse.uvs.push_back(mesh_.uvs[vertex]);
      if (!mesh_.colors.empty()) coarse.colors.push_back(mesh_.colors[vertex]);
    }
    return coarse;
  }

 private:
  template <class T>
  static Column<T> of_kept(const Column<T>& items, const std::vector<std::uint32_t>& kept) {
    if (items.empty()) return {};
    Column<T> result(kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i) result.set(i, items[kept[i]]);
    return result;
  }

  const Mesh& mesh_;
  Zeroed<std::uint64_t> cell_of_;
  std::size_t triangles_ = 0;
};

}  // namespace

Mesh decimate(const Mesh& mesh, std::size_t triangles, const Cancel& cancel) {
  if (mesh.triangles.size() <= triangles) return mesh;
  CancelEvery steps(cancel);
  const Cube cube(mesh.positions, steps);
  const auto count = [&](std::size_t cells) { return Clustering(mesh, cube, cells, cancel).triangles(); };
  std::size_t coarse = 1, fine = finest;  // one cell keeps nothing
  while (fine - coarse > 1 && !cancel.stopped()) {
    const std::size_t middle = coarse + (fine - coarse) / 2;
    (count(middle) <= triangles ? coarse : fine) = middle;
  }
  // Where even the finest grid that keeps to the number leaves nothing, the next one does not.
  while (coarse < finest && count(coarse) == 0 && !cancel.stopped()) ++coarse;
  return Clustering(mesh, cube, coarse, cancel).mesh(cancel);
}

}  // namespace dini

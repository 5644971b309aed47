#include "geometry/subdivide.h"

#include <algorithm>

#include "geometry/chunks.h"
#include "geometry/number_table.h"

namespace dini {

namespace {

/// The vertices of a mesh while middles of edges are added to them.
class Middles {
 public:
  Middles(const Mesh& mesh, const Cancel& cancel)
      : mesh_(mesh), cancel_(cancel), next_(static_cast<std::uint32_t>(mesh.positions.size())) {}

  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [found, fresh] = vertex_of_.try_emplace((std::uint64_t{low} << 32) | high, next_, cancel_);
    if (fresh) {
      edges_.push_back({low, high});
      ++next_;
    }
    return found;
  }

  /// The old vertices followed by the middles.
  void write(Mesh& finer) const {
    finer.positions = extended(*mesh_.positions, [](const Point& a, const Point& b) {
      return to_point(0.5 * to_vector(a) + 0.5 * to_vector(b));
    });
    if (!mesh_.normals.empty()) {
      finer.normals = extended(*mesh_.normals, [](const Vector& a, const Vector& b) {
        const Vector middle = normalized(a + b);
        return middle == Vector{} ? a : middle;
      });
    }
    finer.uvs = extended(*mesh_.uvs);
    finer.colors = extended(*mesh_.colors);
  }

 private:
  template <class T, class Middle>
  Column<T> extended(const Column<T>& items, Middle middle) const {
    Column<T> all(items.size() + edges_.size());
    for_chunks(cancel_, all.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < std::min(end, items.size()); ++i) all.set(i, items[i]);
      for (std::size_t i = std::max(begin, items.size()); i < end; ++i) {
        const auto& [a, b] = edges_[i - items.size()];
        all.set(i, middle(items[a], items[b]));
      }
    });
    return all;
  }

  template <class Number, std::size_t N>
  NumberList<std::array<Number, N>> extended(const NumberList<std::array<Number, N>>& items) const {
    if (items.empty()) return {};
    NumberList<std::array<Number, N>> all(items.size() + edges_.size());
    for_chunks(cancel_, all.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < std::min(end, items.size()); ++i) all[i] = items[i];
      for (std::size_t i = std::max(begin, items.size()); i < end; ++i) {
        const auto& [a, b] = edges_[i - items.size()];
        for (std::size_t k = 0; k < N; ++k) all[i][k] = (items[a][k] + items[b][k]) / 2;
      }
    });
    return all;
  }

  const Mesh& mesh_;
  const Cancel& cancel_;
  std::uint32_t next_;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  NumberTable vertex_of_;  ///< by edge
};

Mesh finer_by_one(const Mesh& mesh, const Cancel& cancel) {
  Middles middles(mesh, cancel);
  Mesh finer;
  finer.color = mesh.color;
  finer.finish = mesh.finish;
  NumberList<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(4 * mesh.triangles.size());
  CancelEvery steps(cancel);
  for (const auto& [a, b, c] : mesh.triangles) {
    if (steps.stopped()) return {};
    const std::uint32_t ab = middles.between(a, b), bc = middles.between(b, c), ca = middles.between(c, a);
    triangles.push_back({a, ab, ca});
    triangles.push_back({ab, b, bc});
    triangles.push_back({ca, bc, c});
    triangles.push_back({ab, bc, ca});
  }
  finer.triangles = std::move(triangles);
  for (const std::size_t end : mesh.tile_ends) finer.tile_ends.push_back(4 * end);
  middles.write(finer);
  return finer;
}

}  // namespace

Mesh subdivide(const Mesh& mesh, std::size_t levels, const Cancel& cancel) {
  if (levels == 0) return mesh;
  Mesh result = finer_by_one(mesh, cancel);
  for (std::size_t level = 1; level < levels && !cancel.stopped(); ++level) result = finer_by_one(result, cancel);
  return result;
}

}  // namespace dini

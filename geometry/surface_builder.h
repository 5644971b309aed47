#pragma once

// Turns the samples of a grid into triangles: numbers vertices as they are first used, cuts triangles at the clip
// sphere.

#include <vector>

#include "geometry/grid_samples.h"
#include "geometry/number_table.h"

namespace dini {

/// A vertex that is a sample (`to` equals `from`), or lies on the way between two samples.
struct SurfaceVertex {
  std::size_t from = 0, to = 0;
  double way = 0;  ///< 0 at `from`, 1 at `to`
};

/// Collects the triangles of a surface. Feed it quads; then read what it collected.
class SurfaceBuilder {
 public:
  SurfaceBuilder(const GridSamples& samples, const Cancel& cancel);

  /// Adds the triangles of quad (row, column).
  void add_quad(std::size_t row, std::size_t column);

  /// Ends a tile, unless nothing was added to it.
  void end_tile();

  std::size_t clipped_quads() const { return clipped_quads_; }
  const std::vector<SurfaceVertex>& vertices() const { return vertices_; }

  /// The mesh without normals; the builder is empty afterwards, but for `vertices()`.
  Mesh take_mesh();

 private:
  using Corners = std::array<std::size_t, 3>;

  void add_triangle(const Corners& corners);
  void emit(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  std::uint32_t sample_vertex(std::size_t sample);
  std::uint32_t cut_vertex(std::size_t inside, std::size_t outside);
  std::uint32_t add_vertex(const SurfaceVertex& vertex, const Vector& position, const std::array<double, 2>& uv);
  std::array<double, 2> coordinates(std::size_t sample) const;

  const GridSamples& samples_;
  const Cancel& cancel_;
  std::vector<std::uint32_t> vertex_of_;  ///< by label of a sample
  NumberTable vertex_of_cut_;             ///< by samples inside and outside
  std::vector<SurfaceVertex> vertices_;
  std::vector<Vector> positions_;
  std::vector<std::array<double, 2>> uvs_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::size_t> tile_ends_;
  std::size_t clipped_quads_ = 0;
};

}  // namespace dini

#include "geometry/surface.h"

#include <algorithm>

#include "geometry/chunks.h"
#include "geometry/grid_normals.h"
#include "geometry/grid_samples.h"
#include "geometry/surface_normals.h"
#include "geometry/surface_tiles.h"
#include "geometry/surface_vertices.h"

namespace dini {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

void write_quads(const GridSamples& samples, const QuadBlock& block, const SurfaceVertices& vertices, Triangle* out) {
  for (std::size_t row = block.row_begin; row < block.row_end; ++row) {
    const std::size_t here = samples.index(row, 0), there = samples.index(samples.rows().next(row), 0);
    const auto write = [&](std::size_t column, std::size_t next) {
      const std::uint32_t a = vertices.of_sample(here + column), b = vertices.of_sample(there + column);
      const std::uint32_t c = vertices.of_sample(there + next), d = vertices.of_sample(here + next);
      *out++ = {a, b, c};
      *out++ = {a, c, d};
    };
    const std::size_t straight_end = std::min(block.column_end, samples.columns().size() - 1);
    for (std::size_t column = block.column_begin; column < straight_end; ++column) write(column, column + 1);
    if (straight_end < block.column_end) write(straight_end, 0);
  }
}

/// Writes the triangles of all tiles and their ends.
void write_triangles(const GridSamples& samples, const std::vector<SurfaceTile>& tiles, const SurfaceVertices& vertices,
                     Mesh& mesh, const Cancel& cancel) {
  std::vector<std::size_t> begins;
  std::size_t count = 0;
  for (const SurfaceTile& tile : tiles) {
    begins.push_back(count);
    count += tile.triangles();
    if (count > begins.back()) mesh.tile_ends.push_back(count);
  }
  auto& triangles = mesh.triangles.edit();
  triangles.resize(count);
  for_chunks(cancel, tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Triangle* out = triangles.data() + begins[i];
      if (!tiles[i].irregular) {
        write_quads(samples, tiles[i].block, vertices, out);
        continue;
      }
      for (Triangle triangle : tiles[i].irregular->triangles) {
        for (std::uint32_t& corner : triangle) {
          corner = corner < samples.size() ? vertices.of_sample(corner) : vertices.of_cut(i, corner - samples.size());
        }
        *out++ = triangle;
      }
    }
  });
}

/// Writes positions, normals and texture coordinates of the vertices.
void write_vertices(const GridSamples& samples, const SurfaceVertices& vertices, Column<Vector> normals, Mesh& mesh,
                    const Cancel& cancel) {
  Column<Point> positions = Column<Point>::unwritten(vertices.size());
  Column<Vector> kept_normals(vertices.are_samples() ? 0 : vertices.size());
  NumberList<std::array<double, 2>> uvs(vertices.size());
  std::vector<double> v(samples.columns().size());
  for (std::size_t column = 0; column < v.size(); ++column) v[column] = samples.columns().coordinate(column);
  const std::array<const double*, 3> from = {samples.positions().x, samples.positions().y, samples.positions().z};
  const std::size_t columns = samples.columns().size();
  const std::size_t rows_at_once = std::max<std::size_t>(1, usual_chunk / columns);
  for_chunks(cancel, samples.rows().size(), rows_at_once, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const std::size_t first = samples.index(row, 0);
      const double u = samples.rows().coordinate(row);
      if (vertices.are_samples()) {
        for (std::size_t k = 0; k < from.size(); ++k) {
          std::copy_n(from[k] + first, columns, positions.component(k) + first);
        }
        for (std::size_t column = 0; column < columns; ++column) uvs[first + column] = {u, v[column]};
        continue;
      }
      for (std::size_t column = 0; column < columns; ++column) {
        if (!vertices.uses(first + column)) continue;
        const std::uint32_t vertex = vertices.of_sample(first + column);
        positions.set(vertex, to_point(samples.position(first + column)));
        kept_normals.set(vertex, normals[first + column]);
        uvs[vertex] = {u, v[column]};
      }
    }
  });
  for (std::size_t i = 0; i < vertices.cuts().size(); ++i) {
    positions.set(vertices.sample_count() + i, to_point(vertices.cuts()[i].position));
    uvs[vertices.sample_count() + i] = vertices.cuts()[i].uv;
  }
  mesh.positions = std::move(positions);
  mesh.normals = vertices.are_samples() ? std::move(normals) : std::move(kept_normals);
  mesh.uvs = std::move(uvs);
}

}  // namespace

SurfaceResult surface(const PointGrid& grid, const SurfaceOptions& options, const Cancel& cancel) {
  SurfaceResult result;
  GridSamples samples(grid, options, cancel);
  if (cancel.stopped() || samples.size() == 0) return result;
  const GridNormals by_differences(samples, cancel);
  Zeroed<std::uint8_t> doubtful(samples.size());
  Column<Vector> normals = by_differences.all(doubtful, cancel);
  if (cancel.stopped()) return result;
  const std::vector<TileFacts> facts = tile_facts(samples, normals, doubtful, cancel);
  std::vector<QuadBlock> long_steps, merged;
  for (const TileFacts& tile : facts) {
    if (tile.facts.long_steps) long_steps.push_back(tile.block);
    if (tile.facts.merged) merged.push_back(tile.block);
  }
  samples.tear(long_steps, cancel);
  if (cancel.stopped()) return result;
  result.first_clipped = samples.first_clipped();
  if (options.at_infinity == AtInfinity::fail && result.first_clipped) return result;
  samples.weld(merged, cancel);
  by_differences.doubt_obstructed(doubtful, cancel);
  if (cancel.stopped()) return result;

  const std::vector<SurfaceTile> tiles = surface_tiles(samples, facts, normals, doubtful, cancel);
  if (cancel.stopped()) return result;
  for (const SurfaceTile& tile : tiles) {
    if (tile.irregular) result.clipped_quads += tile.irregular->clipped_quads;
  }
  if (tiles.empty()) return result;
  const SurfaceVertices vertices(samples, tiles, cancel);
  if (cancel.stopped()) return result;
  write_triangles(samples, tiles, vertices, result.mesh, cancel);
  if (cancel.stopped()) return {};
  write_vertices(samples, vertices, std::move(normals), result.mesh, cancel);
  settle_normals(samples, by_differences, tiles, vertices, doubtful, result.mesh, cancel);
  if (cancel.stopped()) result.mesh = {};
  return result;
}

}  // namespace dini

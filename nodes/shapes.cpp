#include "nodes/shapes.h"

#include <algorithm>
#include <cmath>

#include "geometry/chunks.h"
#include "geometry/tile_ends.h"

namespace dini {

namespace {

/// Farther than this from the origin a vertex counts as at infinity: single precision still holds it with room to
/// spare.
constexpr double farthest = 1e9;

bool within_reach(const Point& p) {
  return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest && std::abs(p.z) <= farthest;
}

/// The items of the vertices that are kept; attributes of vertices may be absent.
template <class T>
void keep_used(Shared<NumberList<T>>& items, const std::vector<std::uint32_t>& used, CancelEvery& steps) {
  if (items.empty()) return;
  NumberList<T> kept;
  kept.reserve(used.size());
  for (const std::uint32_t vertex : used) {
    if (steps.stopped()) break;
    kept.push_back(items[vertex]);
  }
  items = std::move(kept);
}

template <class T>
void keep_used(Shared<Column<T>>& items, const std::vector<std::uint32_t>& used, CancelEvery& steps) {
  if (items.empty()) return;
  Column<T> kept(used.size());
  for (std::size_t i = 0; i < used.size() && !steps.stopped(); ++i) kept.set(i, items[used[i]]);
  items = std::move(kept);
}

/// Takes out the triangles that touch a vertex out of reach, and vertices that nothing uses then; one attribute after
/// another, so that a mesh never exists twice. Stopped early: not a whole mesh.
void leave_out_far_triangles(Mesh& mesh, const Cancel& cancel) {
  constexpr std::uint32_t unused = ~std::uint32_t{0};
  std::vector<std::uint32_t> place(mesh.positions.size(), unused);
  std::vector<std::uint32_t> used;
  std::vector<std::size_t> tile_ends;
  NumberList<std::array<std::uint32_t, 3>> triangles;
  std::size_t tile = 0;
  CancelEvery steps(cancel);
  for (std::size_t t = 0; t < mesh.triangles.size() && !steps.stopped(); ++t) {
    const auto triangle = mesh.triangles[t];
    if (std::all_of(triangle.begin(), triangle.end(),
                    [&](std::uint32_t v) { return within_reach(mesh.positions[v]); })) {
      std::array<std::uint32_t, 3>& moved = triangles.emplace_back();
      for (std::size_t corner = 0; corner < 3; ++corner) {
        std::uint32_t& to = place[triangle[corner]];
        if (to == unused) {
          to = static_cast<std::uint32_t>(used.size());
          used.push_back(triangle[corner]);
        }
        moved[corner] = to;
      }
    }
    while (tile < mesh.tile_ends.size() && mesh.tile_ends[tile] == t + 1) {
      end_tile(tile_ends, triangles.size());
      ++tile;
    }
  }
  mesh.triangles = std::move(triangles);
  mesh.tile_ends = std::move(tile_ends);
  keep_used(mesh.positions, used, steps);
  keep_used(mesh.normals, used, steps);
  keep_used(mesh.uvs, used, steps);
  keep_used(mesh.colors, used, steps);
}

}  // namespace

kernels::ConstPoints spread(const Batch<Point>& points, std::size_t size, std::vector<double>& storage) {
  if (!points.constant) return {points.components[0], points.components[1], points.components[2]};
  storage.resize(3 * size);
  for (std::size_t k = 0; k < 3; ++k) std::fill_n(storage.data() + k * size, size, *points.components[k]);
  return {storage.data(), storage.data() + size, storage.data() + 2 * size};
}

kernels::ConstNumbers numbers(const Batch<double>& batch) { return {batch.components[0], batch.constant}; }

kernels::Points components(const BatchOut<Point>& out) {
  return {out.components[0], out.components[1], out.components[2]};
}

kernels::ConstPoints components(const Column<Point>& column, std::size_t begin) {
  return {column.component(0) + begin, column.component(1) + begin, column.component(2) + begin};
}

kernels::Points components(Column<Point>& column, std::size_t begin) {
  return {column.component(0) + begin, column.component(1) + begin, column.component(2) + begin};
}

std::optional<Failure> apply_to_points(const Versor& versor, const Batch<Point>& shape, const BatchOut<Point>& out) {
  std::vector<double> storage;
  kernels::transform_points(versor, spread(shape, out.size, storage), components(out), out.size);
  return std::nullopt;
}

SharedMesh apply_to_mesh(const Context& context, const Versor& versor, const SharedMesh& mesh) {
  Column<Point> positions(mesh->positions.size());
  Column<Vector> normals(mesh->normals.size());
  for_chunks(context.cancel(), positions.size(), [&](std::size_t begin, std::size_t end) {
    kernels::transform_points(versor, components(mesh->positions, begin), components(positions, begin), end - begin);
    for (std::size_t i = begin; i < end && !normals.empty(); ++i) {
      const Vector normal = normalized(apply_at(versor, mesh->positions[i], mesh->normals[i]));
      normals.set(i, is_finite(normal) && normal != Vector{} ? normal : mesh->normals[i]);
    }
  });
  return with_positions(context, *mesh, std::move(positions), std::move(normals));
}

std::shared_ptr<Mesh> with_positions(const Context& context, const Mesh& mesh, Column<Point> positions,
                                     Column<Vector> normals) {
  auto moved = std::make_shared<Mesh>(mesh);
  moved->positions = std::move(positions);
  moved->normals = std::move(normals);
  const Column<Point>& places = *moved->positions;
  const auto is_far = [&](std::size_t vertex) { return !within_reach(places[vertex]); };
  if (first_where(context.cancel(), places.size(), is_far)) {
    const std::size_t before = moved->triangles.size();
    leave_out_far_triangles(*moved, context.cancel());
    context.warn({"at-infinity",
                  std::to_string(before - moved->triangles.size()) + " triangles reach infinity and are left out"});
  }
  return moved;
}

}  // namespace dini

#include "gltf/tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "geometry/validate.h"
#include "gltf/tile_lanes.h"

namespace dini {
namespace {

constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

EncodeError invalid(std::string detail) { return {EncodeError::Code::invalid_input, std::move(detail), ""}; }

std::optional<EncodeError> check_coordinate(const char* what, std::size_t vertex, double value) {
  if (std::abs(value) < largest_coordinate) return std::nullopt;
  const std::string where = std::string(what) + " of vertex " + std::to_string(vertex);
  if (std::isfinite(value)) return EncodeError{EncodeError::Code::too_large, "The " + where + " is beyond 1e18.", ""};
  return EncodeError{EncodeError::Code::non_finite, "The " + where + " is not finite.", ""};
}

std::array<float, 3> to_float(const Vector& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

constexpr double least_usual_normal = 1e-3, greatest_usual_normal = 1e3;

// Draco never sees a zero or NaN normal. Unit normals, the rule, pass without a square root.
std::array<float, 3> drawable_normal(const Vector& normal) {
  const double size = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
  if (size > least_usual_normal && size < greatest_usual_normal) return to_float(normal);
  if (size > 0 && is_finite(normal)) return to_float(normalized(normal));
  return {0, 0, 1};
}

// A share of 1 in steps of 1/4096. Every 8-bit color of a picture comes back from those, where the 255 steps of a byte
// leave 5 of the 34 darkest; finer ones cost bytes and are not seen (docs/decisions/0018-colors-in-16-bits.md).
std::uint16_t color_channel(float value) {
  if (!(value > 0)) return 0;
  constexpr float steps = 4096;
  constexpr long step = 16;
  return static_cast<std::uint16_t>(std::min(step * std::lround(steps * std::min(value, 1.0f)), 65535L));
}

// Triangles between two looks at the flag.
constexpr std::size_t run = 4096;

/// Calls body(begin, end) for runs of `size` elements; false when stopped before the last.
template <class Body>
bool in_runs(std::size_t size, const Cancel& cancel, Body body) {
  for (std::size_t begin = 0; begin < size; begin += run) {
    if (cancel.stopped()) return false;
    body(begin, std::min(begin + run, size));
  }
  return !cancel.stopped();
}

EncodeError index_out_of_range(const Mesh& mesh, std::size_t begin) {
  for (std::size_t i = begin;; ++i) {
    for (const std::uint32_t vertex : mesh.triangles[i]) {
      if (vertex < mesh.positions.size()) continue;
      return invalid("Triangle " + std::to_string(i) + " uses vertex " + std::to_string(vertex) + " of " +
                     std::to_string(mesh.positions.size()) + ".");
    }
  }
}

// Fills `tile.triangles` and returns the vertices of the mesh in the order of first use.
EncodeResult<std::vector<std::uint32_t>> renumber(const Mesh& mesh, std::size_t begin, std::size_t end,
                                                  const Cancel& cancel, Tile& tile) {
  const std::array<std::uint32_t, 3>* const triangles = mesh.triangles.data() + begin;
  const std::size_t count = end - begin;
  std::vector<std::uint32_t> vertices;
  if (count == 0) return vertices;
  std::uint32_t least = unused, most = 0;
  const bool all_seen = in_runs(count, cancel, [&](std::size_t from, std::size_t to) {
    const tile_lanes::IndexRange range = tile_lanes::range_of(triangles[from].data(), 3 * (to - from));
    least = std::min(least, range.least);
    most = std::max(most, range.greatest);
  });
  if (!all_seen) return canceled();
  if (most >= mesh.positions.size()) return index_out_of_range(mesh, begin);

  std::vector<std::uint32_t> numbers(most - least + 1, unused);
  vertices.resize(std::min(numbers.size(), 3 * count));
  tile.triangles.resize(count);
  std::array<std::uint32_t, 3>* out = tile.triangles.data();
  std::uint32_t known = 0;
  const bool all_renumbered = in_runs(count, cancel, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const auto [a, b, c] = triangles[i];
      if (a == b || b == c || c == a) continue;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        std::uint32_t& number = numbers[triangles[i][corner] - least];
        if (number == unused) {
          vertices[known] = triangles[i][corner];
          number = known++;
        }
        (*out)[corner] = number;
      }
      ++out;
    }
  });
  if (!all_renumbered) return canceled();
  tile.triangles.resize(static_cast<std::size_t>(out - tile.triangles.data()));
  vertices.resize(known);
  return vertices;
}

// One coordinate of a run of vertices, after another in `out`, and its bounds. False when any of them cannot be drawn:
// which one, and why, is found by another look.
template <std::size_t N>
bool gather(const double* values, std::size_t stride, const std::uint32_t* vertices, std::size_t count,
            std::array<float, N>* out, std::size_t axis, FloatBox& box) {
  std::array<float, run> rounded = {};
  tile_lanes::Bounds bounds = {box.minimum[axis], box.maximum[axis]};
  const bool drawable =
      tile_lanes::round_values(values, stride, vertices, count, largest_coordinate, rounded.data(), bounds);
  box.minimum[axis] = bounds.minimum;
  box.maximum[axis] = bounds.maximum;
  for (std::size_t i = 0; i < count; ++i) out[i][axis] = rounded[i];
  return drawable;
}

std::optional<EncodeError> gather_positions(const Mesh& mesh, const std::vector<std::uint32_t>& vertices,
                                            const Cancel& cancel, Tile& tile) {
  const Column<Point>& positions = *mesh.positions;
  tile.positions.resize(vertices.size());
  bool drawable = true;
  const bool all = in_runs(vertices.size(), cancel, [&](std::size_t begin, std::size_t end) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      drawable &= gather(positions.component(axis), 1, vertices.data() + begin, end - begin,
                         tile.positions.data() + begin, axis, tile.position_box);
    }
  });
  if (!all) return canceled();
  if (drawable) return std::nullopt;
  for (const std::uint32_t vertex : vertices) {
    const Point p = positions[vertex];
    for (const double value : {p.x, p.y, p.z}) {
      if (auto error = check_coordinate("position", vertex, value)) return error;
    }
  }
  return std::nullopt;
}

std::optional<EncodeError> gather_uvs(const Mesh& mesh, const std::vector<std::uint32_t>& vertices,
                                      const Cancel& cancel, Tile& tile) {
  const auto& uvs = *mesh.uvs;
  tile.uvs.resize(vertices.size());
  bool drawable = true;
  const bool all = in_runs(vertices.size(), cancel, [&](std::size_t begin, std::size_t end) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      drawable &= gather(uvs.front().data() + axis, 2, vertices.data() + begin, end - begin, tile.uvs.data() + begin,
                         axis, tile.uv_box);
    }
  });
  if (!all) return canceled();
  tile.uv_box.minimum[2] = tile.uv_box.maximum[2] = 0;
  if (drawable) return std::nullopt;
  for (const std::uint32_t vertex : vertices) {
    for (const double value : uvs[vertex]) {
      if (auto error = check_coordinate("texture coordinate", vertex, value)) return error;
    }
  }
  return std::nullopt;
}

bool gather_normals(const Column<Vector>& normals, const std::vector<std::uint32_t>& vertices, const Cancel& cancel,
                    Tile& tile) {
  tile.normals.resize(vertices.size());
  return in_runs(vertices.size(), cancel, [&](std::size_t begin, std::size_t end) {
    std::array<float, run> x = {}, y = {}, z = {};
    const bool usual = tile_lanes::round_vectors({normals.component(0), normals.component(1), normals.component(2)},
                                                 vertices.data() + begin, end - begin, least_usual_normal,
                                                 greatest_usual_normal, {x.data(), y.data(), z.data()});
    for (std::size_t i = begin; i < end; ++i) {
      tile.normals[i] = usual ? std::array<float, 3>{x[i - begin], y[i - begin], z[i - begin]}
                              : drawable_normal(normals[vertices[i]]);
    }
  });
}

}  // namespace

TileSizes tile_sizes(const EncodeOptions& options) {
  constexpr int slow = 4;
  return options.speed < slow ? TileSizes{24576, 32768} : TileSizes{};
}

std::vector<std::size_t> plan_tiles(const Mesh& mesh, const TileSizes& sizes) {
  std::vector<std::size_t> given = mesh.tile_ends;
  if (given.empty()) given.push_back(mesh.triangles.size());
  std::vector<std::size_t> ends;
  std::size_t tile_begin = 0;
  std::size_t run_begin = 0;
  for (const std::size_t run_end : given) {
    const std::size_t run = run_end - run_begin;
    const std::size_t pieces = run <= sizes.largest ? 1 : (run + sizes.usual - 1) / sizes.usual;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      const std::size_t begin = run_begin + run * piece / pieces;
      const std::size_t end = run_begin + run * (piece + 1) / pieces;
      if (end - tile_begin > sizes.largest && begin > tile_begin) {
        ends.push_back(begin);
        tile_begin = begin;
      }
    }
    run_begin = run_end;
  }
  if (run_begin > tile_begin) ends.push_back(run_begin);
  return ends;
}

std::optional<EncodeError> check_mesh(const Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  if (vertices >= unused) return EncodeError{EncodeError::Code::too_large, "The mesh has too many vertices.", ""};
  const auto fits = [vertices](std::size_t size) { return size == 0 || size == vertices; };
  if (!fits(mesh.normals.size())) return invalid("The mesh has not one normal per vertex.");
  if (!fits(mesh.uvs.size())) return invalid("The mesh has not one texture coordinate per vertex.");
  if (!fits(mesh.colors.size())) return invalid("The mesh has not one color per vertex.");
  if (mesh.tile_ends.empty()) return std::nullopt;
  if (!std::is_sorted(mesh.tile_ends.begin(), mesh.tile_ends.end()) || mesh.tile_ends.back() != mesh.triangles.size()) {
    return invalid("The tiles of the mesh do not cover its triangles in order.");
  }
  return std::nullopt;
}

EncodeResult<Tile> build_tile(const Mesh& mesh, std::size_t begin, std::size_t end, const EncodeOptions& options,
                              const Cancel& cancel) {
  Tile tile;
  auto renumbered = renumber(mesh, begin, end, cancel, tile);
  if (!renumbered) return std::move(renumbered).error();
  const std::vector<std::uint32_t>& vertices = *renumbered;
  if (vertices.empty()) return tile;
  if (auto error = gather_positions(mesh, vertices, cancel, tile)) return std::move(*error);
  if (options.uvs && !mesh.uvs.empty()) {
    if (auto error = gather_uvs(mesh, vertices, cancel, tile)) return std::move(*error);
  }
  bool all = true;
  if (options.normals && !mesh.normals.empty()) {
    all = gather_normals(*mesh.normals, vertices, cancel, tile);
  }
  if (options.colors && !mesh.colors.empty()) {
    const auto& colors = *mesh.colors;
    tile.colors.resize(vertices.size());
    all = all && in_runs(vertices.size(), cancel, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) {
              const auto& [red, green, blue, alpha] = colors[vertices[i]];
              tile.colors[i] = {color_channel(red), color_channel(green), color_channel(blue), color_channel(alpha)};
            }
          });
  }
  if (!all) return canceled();
  return tile;
}

}  // namespace dini

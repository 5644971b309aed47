#include "gltf/tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "geometry/validate.h"

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

// Draco never sees a zero or NaN normal. Unit normals, the rule, pass without a square root.
std::array<float, 3> drawable_normal(const Vector& normal) {
  const double size = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
  if (size > 1e-3 && size < 1e3) return to_float(normal);
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

// Fills `tile.triangles` and returns the vertices of the mesh in the order of first use.
EncodeResult<std::vector<std::uint32_t>> renumber(const Mesh& mesh, std::size_t begin, std::size_t end,
                                                  const Cancel& cancel, Tile& tile) {
  CancelEvery steps(cancel);
  std::uint32_t first = unused;
  std::uint32_t last = 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (steps.stopped()) return canceled();
    for (const std::uint32_t vertex : mesh.triangles[i]) {
      if (vertex >= mesh.positions.size()) {
        return invalid("Triangle " + std::to_string(i) + " uses vertex " + std::to_string(vertex) + " of " +
                       std::to_string(mesh.positions.size()) + ".");
      }
      first = std::min(first, vertex);
      last = std::max(last, vertex);
    }
  }
  std::vector<std::uint32_t> vertices;
  if (begin == end) return vertices;
  std::vector<std::uint32_t> renumbered(last - first + 1, unused);
  tile.triangles.reserve(end - begin);
  for (std::size_t i = begin; i < end; ++i) {
    if (steps.stopped()) return canceled();
    const auto& triangle = mesh.triangles[i];
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
    auto& target = tile.triangles.emplace_back();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::uint32_t& number = renumbered[triangle[corner] - first];
      if (number == unused) {
        number = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(triangle[corner]);
      }
      target[corner] = number;
    }
  }
  return vertices;
}

std::optional<EncodeError> gather_positions(const Mesh& mesh, const std::vector<std::uint32_t>& vertices,
                                            const Cancel& cancel, Tile& tile) {
  tile.positions.reserve(vertices.size());
  CancelEvery steps(cancel);
  for (const std::uint32_t vertex : vertices) {
    if (steps.stopped()) return canceled();
    const Vector position = to_vector(mesh.positions[vertex]);
    for (const double value : {position.x, position.y, position.z}) {
      if (auto error = check_coordinate("position", vertex, value)) return error;
    }
    tile.positions.push_back(to_float(position));
    tile.position_box.include(tile.positions.back());
  }
  return std::nullopt;
}

std::optional<EncodeError> gather_uvs(const Mesh& mesh, const std::vector<std::uint32_t>& vertices,
                                      const Cancel& cancel, Tile& tile) {
  tile.uvs.reserve(vertices.size());
  CancelEvery steps(cancel);
  for (const std::uint32_t vertex : vertices) {
    if (steps.stopped()) return canceled();
    const auto& [u, v] = mesh.uvs[vertex];
    for (const double value : {u, v}) {
      if (auto error = check_coordinate("texture coordinate", vertex, value)) return error;
    }
    tile.uvs.push_back({static_cast<float>(u), static_cast<float>(v)});
    tile.uv_box.include(std::array<float, 3>{tile.uvs.back()[0], tile.uvs.back()[1], 0});
  }
  return std::nullopt;
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
  CancelEvery steps(cancel);
  if (auto error = gather_positions(mesh, vertices, cancel, tile)) return std::move(*error);
  if (options.uvs && !mesh.uvs.empty()) {
    if (auto error = gather_uvs(mesh, vertices, cancel, tile)) return std::move(*error);
  }
  if (options.normals && !mesh.normals.empty()) {
    tile.normals.reserve(vertices.size());
    for (const std::uint32_t vertex : vertices) {
      if (steps.stopped()) return canceled();
      tile.normals.push_back(drawable_normal(mesh.normals[vertex]));
    }
  }
  if (options.colors && !mesh.colors.empty()) {
    tile.colors.reserve(vertices.size());
    for (const std::uint32_t vertex : vertices) {
      if (steps.stopped()) return canceled();
      const auto& [red, green, blue, alpha] = mesh.colors[vertex];
      tile.colors.push_back({color_channel(red), color_channel(green), color_channel(blue), color_channel(alpha)});
    }
  }
  return tile;
}

}  // namespace dini

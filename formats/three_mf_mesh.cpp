#include "formats/three_mf_mesh.h"

#include <bit>

#include "geometry/key_numbers.h"

namespace dini {

namespace {

/// The number of a place; 0 and -0 are the same.
std::array<std::uint32_t, 3> key_of(const std::array<float, 3>& place) {
  std::array<std::uint32_t, 3> key{};
  for (std::size_t k = 0; k < 3; ++k) key[k] = std::bit_cast<std::uint32_t>(place[k] == 0 ? 0.0f : place[k]);
  return key;
}

bool is_closed(const std::vector<std::array<std::uint32_t, 3>>& triangles, const Cancel& cancel) {
  using Edge = KeyNumbers<2>::Key;
  KeyNumbers<2> edges;
  CancelEvery steps(cancel);
  for (const auto& [a, b, c] : triangles) {
    if (steps.stopped()) return false;
    for (const Edge& edge : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) {
      if (!edges.number_of(edge).fresh) return false;
    }
  }
  for (const auto& [a, b, c] : triangles) {
    if (steps.stopped()) return false;
    for (const Edge& edge : {Edge{b, a}, Edge{c, b}, Edge{a, c}}) {
      if (edges.number_of(edge).fresh) return false;
    }
  }
  return true;
}

}  // namespace

JoinedMesh joined_mesh(const Tile& tile, const Cancel& cancel) {
  JoinedMesh mesh;
  KeyNumbers<3> places;
  std::vector<std::uint32_t> place_of;
  place_of.reserve(tile.positions.size());
  CancelEvery steps(cancel);
  for (const auto& place : tile.positions) {
    if (steps.stopped()) return mesh;
    const auto [number, fresh] = places.number_of(key_of(place));
    if (fresh) mesh.places.push_back(place);
    place_of.push_back(number);
  }
  for (const auto& triangle : tile.triangles) {
    if (steps.stopped()) return mesh;
    const std::array joined = {place_of[triangle[0]], place_of[triangle[1]], place_of[triangle[2]]};
    if (joined[0] == joined[1] || joined[1] == joined[2] || joined[2] == joined[0]) continue;
    mesh.triangles.push_back(joined);
    mesh.corners.push_back(triangle);
  }
  mesh.closed = is_closed(mesh.triangles, cancel);
  return mesh;
}

}  // namespace dini

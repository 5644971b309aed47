#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// Elements that are copied between two looks at a flag: some milliseconds for the largest.
inline constexpr std::size_t copied_at_once = std::size_t{1} << 16;

/// A copy of `items` with room for more behind them. Stopped early: only the first of them.
template <class T>
std::vector<T> copied(const std::vector<T>& items, const Cancel& cancel, std::size_t room = 0) {
  std::vector<T> copy;
  copy.reserve(items.size() + room);
  for (std::size_t begin = 0; begin < items.size() && !cancel.stopped(); begin += copied_at_once) {
    const std::size_t end = std::min(begin + copied_at_once, items.size());
    copy.insert(copy.end(), items.begin() + static_cast<std::ptrdiff_t>(begin),
                items.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return copy;
}

/// The same for a column of numbers. Stopped early: zeros after the first of them.
template <class T>
requires Column<T>::numeric Column<T> copied(const Column<T>& items, const Cancel& cancel) {
  Column<T> copy(items.size());
  for (std::size_t k = 0; k < Column<T>::width; ++k) {
    for (std::size_t begin = 0; begin < items.size() && !cancel.stopped(); begin += copied_at_once) {
      const std::size_t end = std::min(begin + copied_at_once, items.size());
      std::copy(items.component(k) + begin, items.component(k) + end, copy.component(k) + begin);
    }
  }
  return copy;
}

/// A copy of what a mesh has beside the places, normals and colors of its vertices.
inline Mesh copied_frame(const Mesh& mesh, const Cancel& cancel) {
  Mesh copy;
  copy.uvs = copied(mesh.uvs, cancel);
  copy.triangles = copied(mesh.triangles, cancel);
  copy.tile_ends = copied(mesh.tile_ends, cancel);
  copy.color = mesh.color;
  copy.finish = mesh.finish;
  return copy;
}

/// A copy of a mesh without the colors of its vertices. Stopped early: not a whole mesh.
inline Mesh copied_without_colors(const Mesh& mesh, const Cancel& cancel) {
  Mesh copy = copied_frame(mesh, cancel);
  copy.positions = copied(mesh.positions, cancel);
  copy.normals = copied(mesh.normals, cancel);
  return copy;
}

/// A copy of a whole mesh. Stopped early: not a whole mesh.
inline Mesh copied(const Mesh& mesh, const Cancel& cancel) {
  Mesh copy = copied_without_colors(mesh, cancel);
  copy.colors = copied(mesh.colors, cancel);
  return copy;
}

}  // namespace dini

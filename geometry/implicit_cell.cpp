#include "geometry/implicit_cell.h"

#include <algorithm>

namespace dini {

namespace {

constexpr int edge_from(int axis, int lower) {
  return 4 * axis + (lower >> (axis + 1) % 3 & 1) + 2 * (lower >> (axis + 2) % 3 & 1);
}

struct Face {
  std::array<int, 4> corners;  ///< around it
  std::array<int, 4> edges;    ///< between each corner and the next
};

constexpr std::array<Face, 6> faces = [] {
  std::array<Face, 6> all{};
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int first = face % 2 << axis;
    const std::array<int, 4> corners = {first, first | 1 << u, first | 1 << u | 1 << v, first | 1 << v};
    all[static_cast<std::size_t>(face)] = {
        corners,
        {edge_from(u, corners[0]), edge_from(v, corners[1]), edge_from(u, corners[3]), edge_from(v, corners[0])}};
  }
  return all;
}();

const Face& at(int face) { return faces[static_cast<std::size_t>(face)]; }

}  // namespace

std::array<int, 2> ends_of_edge(int edge) {
  const int axis = edge / 4;
  const int lower = (edge & 1) << (axis + 1) % 3 | (edge >> 1 & 1) << (axis + 2) % 3;
  return {lower, lower | 1 << axis};
}

const std::array<int, 4>& edges_of_face(int face) { return at(face).edges; }

int CellLoops::curve_on(int face, int edge) const {
  const auto& edges = edges_of_face(face);
  const auto place = std::find(edges.begin(), edges.end(), edge) - edges.begin();
  if ((paired >> face & 1) != 0) return place == 1 || place == 2 ? 0 : 1;
  return place < 2 ? 0 : 1;
}

CellLoops loops_of(const std::array<double, 8>& values) {
  CellLoops loops;
  std::array<std::uint8_t, 12> label;
  for (std::uint8_t edge = 0; edge < 12; ++edge) {
    const auto [lower, upper] = ends_of_edge(edge);
    const bool crossed = (values[static_cast<std::size_t>(lower)] < 0) != (values[static_cast<std::size_t>(upper)] < 0);
    label[edge] = crossed ? edge : no_loop;
  }
  const auto join = [&](int a, int b) {
    const std::uint8_t kept = std::min(label[static_cast<std::size_t>(a)], label[static_cast<std::size_t>(b)]);
    const std::uint8_t gone = std::max(label[static_cast<std::size_t>(a)], label[static_cast<std::size_t>(b)]);
    std::replace(label.begin(), label.end(), gone, kept);
  };
  std::uint8_t ambiguous = 0;
  for (int face = 0; face < 6; ++face) {
    const auto& [corners, edges] = at(face);
    std::array<int, 4> crossed{};
    std::size_t count = 0;
    for (const int edge : edges) {
      if (label[static_cast<std::size_t>(edge)] != no_loop) crossed[count++] = edge;
    }
    if (count == 2) join(crossed[0], crossed[1]);
    if (count != 4) continue;
    ambiguous = static_cast<std::uint8_t>(ambiguous | 1 << face);
    const auto value = [&](std::size_t corner) { return values[static_cast<std::size_t>(corners[corner])]; };
    // The saddle has the sign of corners 0 and 2 exactly when these have the larger product: they belong together.
    if (value(0) * value(2) > value(1) * value(3)) {
      join(edges[0], edges[1]);
      join(edges[2], edges[3]);
    } else {
      loops.paired = static_cast<std::uint8_t>(loops.paired | 1 << face);
      join(edges[1], edges[2]);
      join(edges[3], edges[0]);
    }
  }
  std::array<std::uint8_t, 16> numbers;
  numbers.fill(no_loop);
  for (std::size_t edge = 0; edge < 12; ++edge) {
    if (label[edge] == no_loop) {
      loops.loop[edge] = no_loop;
      continue;
    }
    std::uint8_t& number = numbers[label[edge]];
    if (number == no_loop) number = loops.count++;
    loops.loop[edge] = number;
  }
  for (int face = 0; face < 6; ++face) {
    if ((ambiguous >> face & 1) == 0) continue;
    const auto& edges = at(face).edges;
    const bool one = loops.loop[static_cast<std::size_t>(edges[0])] == loops.loop[static_cast<std::size_t>(edges[2])] &&
                     loops.loop[static_cast<std::size_t>(edges[1])] == loops.loop[static_cast<std::size_t>(edges[3])];
    const bool all =
        one && loops.loop[static_cast<std::size_t>(edges[0])] == loops.loop[static_cast<std::size_t>(edges[1])];
    if (all) loops.doubled = static_cast<std::uint8_t>(loops.doubled | 1 << face);
  }
  return loops;
}

}  // namespace dini

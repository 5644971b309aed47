#include "tests/draco/grids.h"

#include <algorithm>
#include <limits>

namespace dini::grids {
namespace {

std::size_t number(std::size_t least, std::size_t most, std::mt19937& random) {
  return std::uniform_int_distribution<std::size_t>(least, most)(random);
}

bool chance(double share, std::mt19937& random) { return std::bernoulli_distribution(share)(random); }

}  // namespace

TriangleList grid(std::size_t rows, std::size_t columns, Wrap wrap, std::mt19937& random) {
  TriangleList list;
  list.vertices = rows * columns;
  const auto vertex = [=](std::size_t row, std::size_t column) {
    return static_cast<std::uint32_t>((row % rows) * columns + column % columns);
  };
  for (std::size_t row = 0; row + (wrap == Wrap::both ? 0 : 1) < rows; ++row) {
    for (std::size_t column = 0; column + (wrap == Wrap::none ? 1 : 0) < columns; ++column) {
      const std::uint32_t a = vertex(row, column), b = vertex(row, column + 1);
      const std::uint32_t c = vertex(row + 1, column + 1), d = vertex(row + 1, column);
      if (chance(0.5, random)) {
        list.triangles.insert(list.triangles.end(), {{a, b, d}, {b, c, d}});
      } else {
        list.triangles.insert(list.triangles.end(), {{a, b, c}, {a, c, d}});
      }
    }
  }
  return list;
}

TriangleList with_holes(const TriangleList& list, double share, std::mt19937& random) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> numbers(list.vertices, none);
  TriangleList left;
  for (const auto& triangle : list.triangles) {
    if (!left.triangles.empty() && !chance(share, random)) continue;
    auto& kept = left.triangles.emplace_back();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::uint32_t& named = numbers[triangle[corner]];
      if (named == none) named = static_cast<std::uint32_t>(left.vertices++);
      kept[corner] = named;
    }
  }
  return left;
}

TriangleList together(const TriangleList& a, const TriangleList& b) {
  TriangleList both = a;
  const auto shift = static_cast<std::uint32_t>(a.vertices);
  for (const auto& [x, y, z] : b.triangles) both.triangles.push_back({x + shift, y + shift, z + shift});
  both.vertices += b.vertices;
  return both;
}

TriangleList any(std::size_t most, std::mt19937& random) {
  const Wrap wrap = static_cast<Wrap>(number(0, 2, random));
  TriangleList list = grid(number(3, most, random), number(3, most, random), wrap, random);
  if (chance(0.3, random))
    list = together(list, grid(number(2, most, random), number(2, most, random), Wrap::none, random));
  if (chance(0.5, random)) list = with_holes(list, static_cast<double>(number(50, 99, random)) / 100, random);
  if (chance(0.3, random)) std::shuffle(list.triangles.begin(), list.triangles.end(), random);
  return list;
}

}  // namespace dini::grids

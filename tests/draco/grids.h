#pragma once

// Triangle lists for the tests of Draco streams.

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace dini::grids {

/// Triangles without positions.
struct TriangleList {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t vertices = 0;
};

/// How a grid of quads is closed: not at all, to a tube, to a torus.
enum class Wrap { none, columns, both };

/// Two triangles for each quad of a grid of `rows` x `columns` vertices (at least 3 in a direction that is closed),
/// each quad cut along one of its diagonals by chance.
TriangleList grid(std::size_t rows, std::size_t columns, Wrap wrap, std::mt19937& random);

/// The triangles that a chance of `share` leaves, their vertices numbered anew in the order of first use.
TriangleList with_holes(const TriangleList& list, double share, std::mt19937& random);

/// Several lists as one, side by side.
TriangleList together(const TriangleList& a, const TriangleList& b);

/// A list of one of these kinds, of at most `most` rows and columns.
TriangleList any(std::size_t most, std::mt19937& random);

}  // namespace dini::grids

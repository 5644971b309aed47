#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algebra/network.h"
#include "geometry/cancel.h"
#include "geometry/column.h"

namespace dini {

/// Which points of a network are neighbors: the nearest ones, found anew at each step, all of one another, or those
/// that a table lists.
enum class NeighborSearch { nearest, all, table };

/// Indices of neighbors, as many for each point: neighbor m of point i is indices[m * points + i]. A point itself
/// stands for one that is missing.
struct NeighborTable {
  std::vector<std::uint32_t> indices;
  std::size_t each = 0;

  /// Each point is its own neighbor, once at least.
  NeighborTable(std::size_t points, std::size_t neighbors);
};

/// Each point beside the one before and the one behind it; the first beside the last when they are `closed`.
NeighborTable chain_of(std::size_t points, bool closed);

/// A network step by step (algebra/network.h): `rows` rows of as many points as there are weights, the first of which
/// is `start`. For the nearest neighbors the table says how many, at most `PointTree::most_neighbors`. All points must
/// be finite. The same for every number of threads. Stopped early: rows that mean nothing.
Column<Point> evolve(const Column<Point>& start, std::span<const double> weights,
                     const kernels::NetworkSettings& settings, NeighborSearch search, NeighborTable neighbors,
                     std::size_t rows, const Cancel& cancel);

}  // namespace dini

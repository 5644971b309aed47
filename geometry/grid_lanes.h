#pragma once

// What is asked of every sample and every quad of a grid, for many at once (Highway). Comparisons are on the safe side:
// whatever they are not sure of is told, and looked at again one by one. Every instruction set gives the same bits.

#include <array>
#include <cstddef>
#include <cstdint>

#include "algebra/kernels.h"

namespace dini::grid_lanes {

/// Whether all points lie within a distance of the origin, and if so their largest coordinate.
struct Extent {
  bool inside = true;
  double largest = 0;
};

/// The extent of `count` points; `squared_radius` is that of the distance. Points that are not finite are not inside.
Extent extent_of(kernels::ConstPoints points, std::size_t count, double squared_radius);

/// The derivative along rows in one row of a grid: weights of the differences between samples of `count` other rows
/// and those of this one. Rows are given by the offsets of their first samples.
struct RowDifferences {
  std::size_t count = 0;
  std::array<std::size_t, 5> rows = {};
  std::array<double, 5> weights = {};
};

/// The derivative along columns: for each column the weights of the differences to the columns 2 and 1 before it, and 1
/// and 2 after it.
using ColumnDifferences = std::array<const double*, 4>;

/// Unit normals along (row direction) x (column direction) at columns [begin, end) of the row that starts at offset
/// `row`; two columns before and after them exist. Where a derivative vanishes or both are parallel, or where numbers
/// become too small or too large to tell, the normal is zero and its byte in `doubtful` becomes 1.
void difference_normals(kernels::ConstPoints points, std::size_t row, const RowDifferences& along_rows,
                        const ColumnDifferences& along_columns, std::size_t begin, std::size_t end,
                        kernels::Points normals, std::uint8_t* doubtful);

/// A run of `count` quads between two rows, as the offsets of the corners of the first: a and b lie on one side, d and
/// c follow them along the columns.
struct QuadRun {
  std::size_t a, b, c, d;
  std::size_t count;
};

/// What a quad is measured with: lengths up to `tolerance` are round-off, steps above `longest_step` may hold infinity.
struct QuadLimits {
  double tolerance;
  double longest_step;
};

/// What is true of any quad of a run.
struct QuadFacts {
  bool irregular = false;  ///< the triangles a b c and a c d may be without area, or folded against each other
  bool merged = false;     ///< corners of a side may coincide; then it is irregular too
  bool long_steps = false;

  QuadFacts& operator|=(const QuadFacts& other) {
    irregular |= other.irregular;
    merged |= other.merged;
    long_steps |= other.long_steps;
    return *this;
  }
};

/// Looks at the quads of a run as the triangles a b c and a c d. Samples whose normal does not look to the front of
/// such a triangle around them become 1 in `doubtful`, which several threads may write at once.
QuadFacts facts_of(kernels::ConstPoints points, kernels::ConstPoints normals, const QuadRun& run,
                   const QuadLimits& limits, std::uint8_t* doubtful);

}  // namespace dini::grid_lanes

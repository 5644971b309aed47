#pragma once

// Meshes from grids of points: the surfaces of Dini.

#include <array>
#include <cstddef>
#include <optional>

#include "geometry/cancel.h"
#include "geometry/mesh.h"

namespace dini {

/// A view of rows x columns points: point (row, column) is points[offset + row * row_stride + column * column_stride].
/// `closed_rows`: the last row joins the first one; likewise `closed_columns`. A closed axis of fewer than three
/// samples is taken as open. `points` must outlive the view and hold every index.
struct PointGrid {
  const Column<Point>& points;
  std::size_t rows = 0;
  std::size_t columns = 0;
  bool closed_rows = false;
  bool closed_columns = false;
  std::size_t offset = 0;
  std::size_t row_stride = columns;
  std::size_t column_stride = 1;
};

/// What happens where a surface runs through infinity: `clip` leaves that part out, `fail` gives no mesh at all.
enum class AtInfinity { clip, fail };

struct SurfaceOptions {
  AtInfinity at_infinity = AtInfinity::clip;
  double clip_radius = 1e3;         ///< meters from the origin, at most 1e17; farther points count as at infinity
  std::size_t triangle_budget = 0;  ///< at most so many triangles before clipping; 0 is no limit
};

struct SurfaceResult {
  Mesh mesh;
  std::size_t clipped_quads = 0;                            ///< quads cut or left out at infinity
  std::optional<std::array<std::size_t, 2>> first_clipped;  ///< the first (row, column) at infinity, in row order
};

/// The surface through a grid of points.
///
/// Orientation: front faces and normals look along (row direction) x (column direction).
/// Closed axes are welded: both sides of the seam share vertices, so a doubly closed grid has Euler number 0.
/// Texture coordinates: u along rows, v along columns; index/size on closed axes, index/(size-1) on open ones. A welded
/// seam has no second copy of its vertices, so there the coordinates run back from (size-1)/size to 0 within one quad.
/// Neighbors that coincide to round-off (1e-12 of the largest coordinate) become one vertex; so a row or column that is
/// a single point is a clean fan around a pole. Triangles without area are left out. Quads are split along the diagonal
/// from (row, column) to (row + 1, column + 1), unless only the other one avoids a fold; so tiles of one size have the
/// same triangles whatever the points are, as long as nothing in them is cut, folded or coincides
/// (docs/decisions/0047). Vertices are the samples that triangles use, in the order of the grid, then those of cuts.
/// Normals come from differences of the samples (fourth order, one-sided at borders); where the two tangents vanish or
/// are parallel, and where they disagree with the triangles, from the triangles around the vertex, weighted by angle.
/// A triangle budget drops rows and columns evenly; ends stay, closed axes stay closed with three samples or more.
///
/// Infinity (`clip`): triangles are cut where an edge leaves the sphere of `clip_radius`; the new vertices are shared,
/// so the border is clean. Triangles with a corner that is not finite are left out; so are quads that turned inside out
/// against their neighbors and outgrew them, for the surface went through infinity between their corners.
/// With `fail` any of these gives an empty mesh and `first_clipped`.
///
/// Grids of one row or one column, of coinciding or of collinear points, or all at infinity give an empty mesh.
/// At most 2^31 samples remain after the budget. Triangles come in tiles of at most 128 x 128 quads (`tile_ends`).
/// Stopped early: no mesh, or part of one.
SurfaceResult surface(const PointGrid& grid, const SurfaceOptions& options, const Cancel& cancel);

}  // namespace dini

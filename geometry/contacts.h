#pragma once

#include <optional>

#include "geometry/welded_mesh.h"

namespace dini {

/// Where a surface meets itself.
struct Contacts {
  std::size_t pairs = 0;        ///< of triangles, up to what was asked for
  std::optional<Vector> place;  ///< the middle of the first triangle of such a pair
};

/// Counts the pairs of triangles that share a point which is on no edge and at no corner that both have: triangles that
/// cross, touch, lie on one another or are folded back. Decided exactly, with coordinates below 1e-60 of the largest
/// taken as zero. Triangles without area are left out. Stops at `most` pairs. A tree of boxes finds candidates: n log n
/// for surfaces, and every pair where all triangles lie in one place. Stopped early: fewer pairs.
Contacts contacts_of(const WeldedMesh& mesh, std::size_t most, const Cancel& cancel);

}  // namespace dini

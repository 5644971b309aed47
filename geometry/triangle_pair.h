#pragma once

#include "geometry/welded_mesh.h"

namespace dini {

/// A triangle of a welded mesh, with coordinates that are exact to compute with (geometry/exact_sign.h).
struct PairCorners {
  Corners vertices;
  std::array<Vector, 3> places;
  int axis = -1;  ///< seen along which it has an area; below 0 where there is none
};

/// The axis along which a triangle shows its area best; below 0 for one that has none.
int axis_of_area(const std::array<Vector, 3>& places);

/// Whether two triangles with areas share a point which is on no edge and at no corner that both have. Exact.
bool triangles_meet(const PairCorners& a, const PairCorners& b);

}  // namespace dini

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/scalar_field.h"

namespace dini {

/// Where the surface crosses an edge of the grid, and its unit normal there.
struct Crossing {
  Vector place;
  Vector normal;
};

/// The vertex of one piece of surface in a cell. On an edge or a corner of the surface it has several normals.
struct ImplicitVertex {
  Vector place;
  std::vector<Vector> normals;
  std::vector<std::uint8_t> normal_of;  ///< for each crossing, which of them is that of its side
};

/// The vertex of the piece of surface that leaves the cell with this center and edge length at the crossings. Where the
/// normals agree it is on the surface, to the accuracy of the field's gradient; where they do not, it is where the
/// tangent planes meet (Ju, Losasso, Schaefer and Warren, Dual Contouring of Hermite Data, 2002). It lies inside the
/// cell, never on its border, so that vertices of two cells never agree. Of several pieces in one cell, which could be
/// taken to one place, each has its vertex in the middle of its crossings.
ImplicitVertex implicit_vertex(const ScalarField& field, std::span<const Crossing> crossings, const Vector& center,
                               double step, bool only_piece);

}  // namespace dini

#pragma once

#include "geometry/welded_mesh.h"

namespace dini {

/// What a printer or a lathe asks of a surface. Vertices at one position count as one.
struct Soundness {
  bool watertight = false;     ///< it has triangles, and each edge has two, which run along it in opposite directions
  std::size_t borders = 0;     ///< closed loops of edges with one triangle; those that meet in a vertex count as one
  std::size_t components = 0;  ///< pieces that no vertex joins
};
Soundness soundness_of(const WeldedMesh& mesh, const Cancel& cancel);

/// Of the solid that a watertight surface encloses, with density 1: about its center, along the axes. Of a surface that
/// is not closed, what the divergence theorem makes of it; of one without volume the middle of its bounds and zeros.
struct MassProperties {
  Vector center;    ///< in meters
  Vector inertia;   ///< moments about x, y and z, in m^5: times the density kg m^2
  Vector products;  ///< the sums of y z, z x and x y
};

/// Sums are compensated, to 1e-12 of the solid's size relative to the middle of its bounds. An inside-out surface is
/// taken as if it were not. Stopped early: meaningless.
MassProperties mass_properties(const WeldedMesh& mesh, const Cancel& cancel);

/// The least distance from the middle of a triangle straight inward to a triangle that faces the other way, to within
/// 60 degrees: the thinnest wall, as finely as the mesh tells; edges of a wedge do not count. 0 where nothing is
/// opposite. n log n. Stopped early: meaningless.
double least_thickness(const WeldedMesh& mesh, const Cancel& cancel);

}  // namespace dini

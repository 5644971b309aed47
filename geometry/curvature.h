#pragma once

#include "geometry/cancel.h"
#include "geometry/mesh.h"
#include "geometry/zeroed.h"

namespace dini {

/// Curvatures at the vertices of a mesh, in 1/m and 1/m^2. The mean curvature of a sphere with outward faces is
/// +1/radius.
struct Curvatures {
  Zeroed<double> gauss;
  Zeroed<double> mean;
};

/// Estimates curvatures from how the normals turn across each triangle (Rusinkiewicz, "Estimating curvatures and their
/// derivatives on triangle meshes", 2004): averaged by area around each vertex, second order on even meshes with good
/// normals, first order at borders. Missing normals are computed. Vertices of no triangle with area get 0. Stopped
/// early: zeros.
Curvatures estimate_curvatures(const Mesh& mesh, const Cancel& cancel);

}  // namespace dini

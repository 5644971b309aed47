#pragma once

// Scenes that the tests of this folder encode.

#include <cstddef>

#include "geometry/scene.h"

namespace dini::shapes {

/// A wavy height field over [0, 2]^2: `rows` x `columns` vertices, unit normals, texture coordinates. `waves`
/// multiplies the number of waves.
Mesh wavy_field(std::size_t rows, std::size_t columns, double waves = 1);

/// A torus about the z axis, radii 1 and 0.4, welded both ways, with exact normals.
Mesh torus(std::size_t around, std::size_t across);

/// One triangle in the plane z = 0.
Mesh single_triangle();

/// `vertices` random points in a box of side `extent` about `center`, joined by `triangles` random triangles.
/// No manifold at all.
Mesh random_soup(unsigned seed, std::size_t vertices, std::size_t triangles, double extent, double center);

/// Cuts the triangles of a field or torus of `rows` x `columns` quads into tiles of `side` x `side` quads.
void cut_into_square_tiles(Mesh& mesh, std::size_t rows, std::size_t columns, std::size_t side);

/// A circle of radius `radius` about the z axis at height `height`.
Polyline circle(std::size_t points, double radius, double height);

/// A scene of one mesh called "mesh".
Scene scene_of(Mesh mesh);

}  // namespace dini::shapes

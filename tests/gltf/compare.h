#pragma once

// Comparing a decoded mesh with its original although encoding reorders vertices and triangles.

#include <array>
#include <string>
#include <vector>

#include "geometry/scene.h"
#include "gltf/glb_writer.h"
#include "gltf/quantization.h"

namespace dini::compare {

/// A corner of a triangle: position and normal.
struct Corner {
  std::array<float, 3> position;
  Vector normal;
};

/// A triangle turned so that its smallest position comes first; its winding is kept.
using Triangle = std::array<Corner, 3>;

/// The grid that encoding `scene` uses.
QuantizationGrid grid_of(const Scene& scene, int bits);

/// All triangles without repeated indices, in the order of their positions, each position rounded to `grid`.
std::vector<Triangle> rounded_triangles(const Mesh& mesh, const QuantizationGrid& grid);

/// The same for a decoded mesh, positions as they are.
std::vector<Triangle> stored_triangles(const Mesh& mesh);

/// True if the positions agree exactly, triangle by triangle, winding included.
bool same_positions(const std::vector<Triangle>& a, const std::vector<Triangle>& b);

/// The largest angle between the normals of matching corners, in radians.
double largest_normal_angle(const std::vector<Triangle>& a, const std::vector<Triangle>& b);

/// The mesh of part `index`.
const Mesh& mesh_of(const Scene& scene, std::size_t index = 0);

/// Encodes and decodes; fails the running test if either fails.
EncodedScene encode(const Scene& scene, const EncodeOptions& options = {});
Scene decode(const std::string& glb);

/// The code of the error that encoding must give.
EncodeError failure(const Scene& scene, const EncodeOptions& options = {});

}  // namespace dini::compare

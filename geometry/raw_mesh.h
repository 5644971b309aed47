#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/imported_mesh.h"

namespace dini {

/// What a reader gathers from a file before it is known to be good. `normals`, `uvs` and `colors` (linear) are empty or
/// one per vertex. A triangle has three different vertices, with finite coordinates below 1e18.
struct RawMesh {
  std::vector<Vector> positions;
  std::vector<Vector> normals;  ///< zero where the file gives none; see `given_normal`
  std::vector<std::array<double, 2>> uvs;
  std::vector<std::array<float, 4>> colors;
  NumberList<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::string> warnings;  ///< what was left out so far
};

/// A normal as the raw mesh takes it: not a number where the file gives one that has no direction.
Vector given_normal(const Vector& normal);

/// The mesh of a file, without vertices of no triangle. Normals get unit length; those that are missing, zero or not
/// finite are computed. Texture coordinates that are not finite become 0, such colors white; colors are cut to [0, 1].
/// What the file gives but cannot be used is a warning with a count. Refuses files without a triangle, with the
/// warnings as the reason, and what is over a limit.
ImportResult finish_import(RawMesh raw, MeshFormat format, const ImportLimits& limits, const Cancel& cancel);

}  // namespace dini

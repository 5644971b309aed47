#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/imported_mesh.h"

namespace dini {

/// What a reader gathers from a file before it is known to be good. `normals`, `uvs` and `colors` are empty or one per
/// vertex; a zero normal is one that the file does not give. Every index is below the number of positions.
struct RawMesh {
  std::vector<Vector> positions;
  std::vector<Vector> normals;
  std::vector<std::array<double, 2>> uvs;
  std::vector<std::array<float, 4>> colors;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The mesh of a file: triangles that use a vertex twice and vertices of no triangle are left out, normals get unit
/// length, missing ones are computed, colors are cut to [0, 1]. Refuses numbers that are not finite or too large, files
/// without a triangle, and what is over a limit.
ImportResult finish_import(RawMesh raw, MeshFormat format, const ImportLimits& limits, const Cancel& cancel);

/// A component of a color as pictures store it (sRGB, in [0, 1]) in linear light; IEC 61966-2-1.
float linear_color(double stored);

}  // namespace dini

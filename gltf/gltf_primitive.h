#pragma once

#include <array>
#include <vector>

#include "gltf/gltf_material.h"
#include "gltf/gltf_skin.h"

namespace dini {

/// How the corners of a primitive make triangles: glTF's code.
enum class GltfMode : std::size_t { triangles = 4, strip = 5, fan = 6 };

/// What a primitive of triangles consists of. The accessors that are not there are null; attributes have one value for
/// each position.
struct GltfPrimitive {
  /// The mode of a primitive, nothing when it draws points or lines.
  static std::optional<GltfMode> mode_of(const GltfJson& primitive);

  GltfPrimitive(GltfDocument& document, const GltfJson& primitive, GltfMode mode);

  GltfMode mode;
  const GltfAccessor *positions = nullptr, *normals = nullptr, *uvs = nullptr, *colors = nullptr, *indices = nullptr;
  GltfWeights weights;
  GltfMaterial material;
};

/// The triangles of a primitive as places among its positions.
struct GltfTriangles {
  std::vector<std::array<std::uint32_t, 3>> list;
  std::size_t repeated = 0;      ///< left out: they use a vertex twice, and not only to go on within a strip
  std::size_t without_area = 0;  ///< left out: two of their corners are zeros that do not stand in the file

  /// At most `most`; a file of a few bytes can ask for any number.
  GltfTriangles(GltfDocument& document, const GltfPrimitive& primitive, std::size_t most);
};

}  // namespace dini

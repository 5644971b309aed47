#pragma once

#include "gltf/mesh_encoder.h"

namespace dini {

/// Compresses tiles with libdraco: edgebreaker with valence traversal, positions and texture coordinates on the grids
/// of the scene, octahedral normals, colors without loss. Speed 10 stores the triangle list instead. An empty tile is
/// an error with code `empty`.
class DracoEncoder final : public MeshEncoder {
 public:
  EncodeResult<EncodedTile> encode(const Tile& tile, const SceneGrids& grids,
                                   const EncodeOptions& options) const override;
};

}  // namespace dini

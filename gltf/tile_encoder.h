#pragma once

#include "gltf/draco_encoder.h"
#include "gltf/mesh_encoder.h"

namespace dini {

/// Compresses tiles with our own writer of Draco streams (draco/) where that does the same as libdraco in a tenth of
/// the time: manifold tiles at speeds 7 to 9. All others go to libdraco.
class TileEncoder final : public MeshEncoder {
 public:
  EncodeResult<EncodedTile> encode(const Tile& tile, const TileGrids& grids,
                                   const EncodeOptions& options) const override;

 private:
  DracoEncoder libdraco_;
};

}  // namespace dini

#pragma once

#include <optional>
#include <string>

#include "draco/topology_cache.h"
#include "geometry/json.h"
#include "gltf/encode_error.h"

namespace dini {

/// Where the binary data of a glTF file is: behind the JSON of a GLB, or inside the JSON as a data URI.
enum class GltfContainer { binary, embedded };

/// How a scene is written. The bytes depend on the scene and on these options only.
struct EncodeOptions {
  int position_bits = 14;  ///< 8..20 bits over the largest extent of all meshes
  int normal_bits = 10;    ///< 6..16 bits per octahedral coordinate
  int uv_bits = 12;        ///< 8..20 bits per texture coordinate over the range of its part
  int speed = 7;           ///< Draco effort: 0 smallest .. 9 fast; 10 stores the triangles nearly uncompressed
  bool draco = true;       ///< false: meshes as plain floats, and none of the four above counts
  bool normals = true;
  bool uvs = true;
  bool colors = true;
  std::string generator = "Dini";  ///< `asset.generator`, with the engine's version if the caller wants it
  Json extras = nullptr;           ///< `asset.extras`; null for none
  GltfContainer container = GltfContainer::binary;
  TopologyCache* topologies = nullptr;  ///< what is known of tiles from other files, if anything; no byte depends on it
};

/// The first option out of its range, if any.
std::optional<EncodeError> check_options(const EncodeOptions& options);

}  // namespace dini

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/cancel.h"
#include "geometry/file_format.h"
#include "geometry/scene.h"
#include "gltf/encode_error.h"
#include "gltf/encode_options.h"
#include "gltf/glb_container.h"
#include "gltf/mesh_encoder.h"

namespace dini {

/// Texture coordinates that the bits of their grid hold only roughly, since they reach far: `error` bounds by how much
/// each of the two may move, where 1 is the size of a picture.
struct RoughUvs {
  std::string part;
  double minimum = 0, maximum = 0, error = 0;
};

/// A scene as a file, and what was written.
struct EncodedScene {
  std::string file;
  std::size_t vertices = 0;            ///< of all primitives as decoded; tiles repeat the vertices of their borders
  std::size_t triangles = 0;           ///< as decoded: triangles with a repeated index are not written
  std::size_t bytes = 0;               ///< size of `file`
  double position_error = 0;           ///< meters per axis: no decoded coordinate is farther from its original
  AttributeErrors attribute_errors{};  ///< no decoded normal, texture coordinate or color is farther from its original
  std::vector<std::string> empty_parts{};  ///< parts that had nothing to draw and were left out
  std::vector<RoughUvs> rough_uvs{};       ///< of parts whose error is above a two-thousandth
};

/// Writes `scene` as glTF: meshes with KHR_draco_mesh_compression in tiles on one common quantization grid, polylines
/// and points as plain floats, one node per part, one root node that turns Z up into Y up. The bytes depend on the
/// scene, the options and the encoder, not on the number of threads. Looks at `cancel` before every tile. A scene with
/// nothing to draw is the error `empty`.
EncodeResult<EncodedScene> encode_scene(const Scene& scene, const EncodeOptions& options, const Cancel& cancel);

/// The same with another compressor for the tiles.
EncodeResult<EncodedScene> encode_scene(const Scene& scene, const EncodeOptions& options, const Cancel& cancel,
                                        const MeshEncoder& encoder);

}  // namespace dini

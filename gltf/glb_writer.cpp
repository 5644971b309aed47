#include "gltf/glb_writer.h"

#include <exception>

#include "gltf/scene_encoding.h"
#include "gltf/tile_encoder.h"

namespace dini {
namespace {

EncodeResult<EncodedScene> encode_unguarded(const Scene& scene, const EncodeOptions& options, const Cancel& cancel,
                                            const MeshEncoder& encoder) {
  SceneEncoding encoding(scene, options, cancel, encoder);
  if (auto error = encoding.prepare()) return std::move(*error);
  GlbModel model(options.generator, options.extras);
  for (const Part& part : scene.parts) {
    model.begin_part({part.name, part.name, part.material});
    if (auto error = encoding.write_next(model)) return std::move(*error);
  }
  EncodedScene result = std::move(encoding.result());
  if (result.empty_parts.size() == scene.parts.size()) {
    return EncodeError{EncodeError::Code::empty, "The scene has nothing to draw.", ""};
  }
  result.file = model.write(options.container);
  result.bytes = result.file.size();
  if (result.file.empty()) return EncodeError{EncodeError::Code::too_large, "The file is larger than 4 GB.", ""};
  return result;
}

}  // namespace

EncodeResult<EncodedScene> encode_scene(const Scene& scene, const EncodeOptions& options, const Cancel& cancel) {
  return encode_scene(scene, options, cancel, TileEncoder());
}

EncodeResult<EncodedScene> encode_scene(const Scene& scene, const EncodeOptions& options, const Cancel& cancel,
                                        const MeshEncoder& encoder) {
  if (auto error = check_options(options)) return std::move(*error);
  try {
    return encode_unguarded(scene, options, cancel, encoder);
  } catch (const std::bad_alloc&) {
    throw;  // no fault of the scene's
  } catch (const std::exception& error) {
    return EncodeError{EncodeError::Code::encoder_failed, error.what(), ""};
  }
}

}  // namespace dini

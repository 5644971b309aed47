#include "gltf/glb_groups.h"

#include <exception>

#include "gltf/scene_encoding.h"
#include "gltf/tile_encoder.h"

namespace dini {

namespace {

/// All parts in their order, each under the name of its group.
Scene flat_scene(const std::vector<GlbGroup>& groups) {
  Scene scene;
  for (const GlbGroup& group : groups) {
    for (const GlbChild& child : group.children) {
      for (const Part& part : child.parts) {
        scene.parts.push_back(part);
        scene.parts.back().name = group.name;
      }
    }
  }
  return scene;
}

EncodeResult<std::string> encode_unguarded(const std::vector<GlbGroup>& groups, const EncodeOptions& options,
                                           const Cancel& cancel) {
  const Scene scene = flat_scene(groups);
  const TileEncoder encoder;
  SceneEncoding encoding(scene, options, cancel, encoder);
  if (auto error = encoding.prepare()) return std::move(*error);
  GlbModel model(options.generator, options.extras);
  for (const GlbGroup& group : groups) {
    model.begin_group(group.name, group.extras);
    for (const GlbChild& child : group.children) {
      model.begin_part({child.name, group.name + "." + child.name, "", child.extras});
      for (std::size_t part = 0; part < child.parts.size(); ++part) {
        if (auto error = encoding.write_next(model)) return std::move(*error);
      }
    }
    model.end_group();
  }
  std::string glb = model.write(GltfContainer::binary);
  if (glb.empty()) return EncodeError{EncodeError::Code::too_large, "The file is larger than 4 GB.", ""};
  return glb;
}

}  // namespace

EncodeResult<std::string> encode_groups(const std::vector<GlbGroup>& groups, const EncodeOptions& options,
                                        const Cancel& cancel) {
  if (auto error = check_options(options)) return std::move(*error);
  try {
    return encode_unguarded(groups, options, cancel);
  } catch (const std::exception& error) {
    return EncodeError{EncodeError::Code::encoder_failed, error.what(), ""};
  }
}

}  // namespace dini

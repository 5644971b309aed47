#include "gltf/gltf_extensions.h"

#include <algorithm>
#include <array>

#include "geometry/text_reader.h"

namespace dini {

namespace {

constexpr std::array<const char*, 2> packed = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

/// The words between the underscores of names: KHR_materials_unlit, EXT_texture_webp, KHR_lights_punctual.
bool is_about_other_things(std::string_view name) {
  constexpr std::array<std::string_view, 22> words = {
      "materials", "material",      "texture",       "textures", "techniques", "packing",
      "lights",    "light",         "animation",     "audio",    "physics",    "interactivity",
      "behavior",  "articulations", "xmp",           "metadata", "features",   "environment",
      "camera",    "hoverability",  "selectability", "lod"};
  while (!name.empty()) {
    const std::size_t end = std::min(name.find('_'), name.size());
    if (std::ranges::find(words, name.substr(0, end)) != words.end()) return true;
    name.remove_prefix(std::min(end + 1, name.size()));
  }
  return false;
}

bool is_read(std::string_view name) { return name == "KHR_mesh_quantization" || name == visibility_extension; }

}  // namespace

void refuse_required_extensions(const GltfJson& root) {
  const auto found = root.find("extensionsRequired");
  if (found == root.end()) return;
  if (!found->is_array()) refuse_gltf("\"extensionsRequired\" must be a list");
  for (const GltfJson& item : *found) {
    if (!item.is_string()) refuse_gltf("\"extensionsRequired\" must hold names");
    const auto& name = item.get_ref<const std::string&>();
    if (name == draco_extension) refuse_draco();
    if (!is_read(name) && !is_about_other_things(name)) {
      refuse_gltf("it requires the extension " + in_quotes(name) + ", which is not supported");
    }
  }
}

void refuse_draco() {
  refuse_gltf(std::string("it is compressed with ") + draco_extension +
              ", which is not unpacked here; export it without compression");
}

void refuse_packed_view(const GltfJson& view) {
  for (const char* name : packed) {
    if (extension_of(view, name) == nullptr) continue;
    refuse_gltf(std::string("it is compressed with ") + name +
                ", which is not unpacked here; export it without compression");
  }
}

}  // namespace dini

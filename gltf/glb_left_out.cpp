#include "gltf/glb_left_out.h"

#include <algorithm>
#include <array>

#include "geometry/counted.h"
#include "gltf/gltf_extensions.h"

namespace dini {

namespace {

/// Whether any weight of morph targets is not zero.
bool has_weights(const GltfJson& object) {
  const auto found = object.find("weights");
  return found != object.end() && found->is_array() &&
         std::any_of(found->begin(), found->end(), [](const GltfJson& weight) { return weight != 0; });
}

/// Of the attributes of a mesh's vertices those that are not read. Tangents belong to textures.
std::size_t count_other_attributes(const GltfJson& mesh) {
  constexpr std::array<std::string_view, 5> read = {"POSITION", "NORMAL", "TANGENT", "TEXCOORD_0", "COLOR_0"};
  std::size_t count = 0;
  for (const GltfJson& primitive : mesh.at("primitives")) {
    const GltfJson* attributes = primitive.is_object() ? object_member(primitive, "attributes") : nullptr;
    if (attributes == nullptr) continue;
    for (const auto& [name, accessor] : attributes->items()) {
      const bool of_skin = name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_");
      count += of_skin || std::ranges::find(read, name) != read.end() ? 0 : 1;
    }
  }
  return count;
}

struct Kind {
  const char* list;
  const char* one;
  const char* many;
};

/// Lists at the top of a document of which nothing comes into a mesh.
constexpr std::array<Kind, 3> other_kinds = {{{"textures", "texture is", "textures are"},
                                              {"animations", "animation is", "animations are"},
                                              {"cameras", "camera is", "cameras are"}}};

}  // namespace

bool GlbLeftOut::is_hidden(const GltfJson& node) {
  const GltfJson* visibility = extension_of(node, visibility_extension);
  const bool hidden = visibility != nullptr && visibility->contains("visible") && !is_true(*visibility, "visible");
  hidden_ += hidden ? 1 : 0;
  return hidden;
}

void GlbLeftOut::add_mesh(std::size_t index, const GltfJson& mesh, const GltfJson& node) {
  if (shown_.insert(index).second) attributes_ += count_other_attributes(mesh);
  morphed_ += has_weights(node.contains("weights") ? node : mesh) ? 1 : 0;
  instanced_ += extension_of(node, instancing_extension) != nullptr ? 1 : 0;
}

void GlbLeftOut::warn(const GltfDocument& document, std::vector<std::string>& warnings) const {
  const auto tell = [&](std::size_t count, std::string_view one, std::string_view many, std::string_view end) {
    if (count > 0) warnings.push_back(counted(count, one, many) + std::string(end));
  };
  tell(hidden_, "hidden node is", "hidden nodes are", " left out");
  tell(document.count("meshes") - std::min(shown_.size(), document.count("meshes")), "mesh is", "meshes are",
       " left out, since the default scene does not show it");
  tell(attributes_, "other attribute of vertices is", "other attributes of vertices are", " left out");
  tell(morphed_, "mesh is", "meshes are", " read without morph targets");
  tell(instanced_, "node is", "nodes are", " read once, without the instances of EXT_mesh_gpu_instancing");
  for (const auto& [list, one, many] : other_kinds) tell(document.count(list), one, many, " left out");
  tell(document.bytes_behind(), "byte behind the end of the file is", "bytes behind the end of the file are",
       " left out");
}

}  // namespace dini

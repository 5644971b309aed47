#pragma once

// Which extensions of glTF stand in the way of reading triangles.

#include "gltf/gltf_json.h"

namespace dini {

inline constexpr const char* draco_extension = "KHR_draco_mesh_compression";
inline constexpr const char* instancing_extension = "EXT_mesh_gpu_instancing";
inline constexpr const char* visibility_extension = "KHR_node_visibility";
inline constexpr const char* specular_glossiness_extension = "KHR_materials_pbrSpecularGlossiness";

/// Refuses a document that requires an extension without which its triangles cannot be read, or that is not known.
/// Those of materials, textures, lights, animation, sound, behavior and metadata change no triangle and are no reason;
/// neither is one that is used but not required.
void refuse_required_extensions(const GltfJson& root);

[[noreturn]] void refuse_draco();

/// Refuses a buffer view whose values are there in compressed form only.
void refuse_packed_view(const GltfJson& view);

}  // namespace dini

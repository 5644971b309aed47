#pragma once

#include "geometry/json.h"
#include "gltf/glb_import.h"
#include "tests/support/import_bytes.h"
#include "tests/support/read_file.h"

namespace dini::support {

/// glTF's codes of components.
enum GltfComponent {
  gltf_i8 = 5120,
  gltf_u8 = 5121,
  gltf_i16 = 5122,
  gltf_u16 = 5123,
  gltf_u32 = 5125,
  gltf_f32 = 5126
};

/// A GLB that grows: one mesh with no primitives yet, shown by one node.
struct GlbParts {
  dini::Json document = dini::Json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": []}], "buffers": [{}], "bufferViews": [], "accessors": []})");
  std::string binary;

  std::size_t view(const Bytes& bytes) {
    document["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.text.size()}});
    binary += bytes.text;
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    return document["bufferViews"].size() - 1;
  }

  /// Without a view when there are no bytes.
  std::size_t accessor(const std::string& type, GltfComponent component, std::size_t count, const Bytes& bytes = {},
                       bool normalized = false) {
    dini::Json entry = {{"type", type}, {"componentType", component}, {"count", count}};
    if (!bytes.text.empty()) entry["bufferView"] = view(bytes);
    if (normalized) entry["normalized"] = true;
    document["accessors"].push_back(entry);
    return document["accessors"].size() - 1;
  }

  std::size_t positions(const std::vector<float>& numbers) {
    return accessor("VEC3", gltf_f32, numbers.size() / 3, Bytes().f32s(numbers));
  }

  dini::Json& primitive(const dini::Json& attributes) {
    document["meshes"][0]["primitives"].push_back({{"attributes", attributes}});
    return document["meshes"][0]["primitives"].back();
  }

  std::string glb() const {
    dini::Json finished = document;
    finished["buffers"][0]["byteLength"] = binary.size();
    return glb_of(finished.dump(), binary);
  }
};

inline const std::vector<float> flat_triangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

/// A GLB of that triangle, with normals along z.
inline GlbParts triangle_parts() {
  GlbParts parts;
  const std::size_t positions = parts.positions(flat_triangle);
  parts.primitive({{"POSITION", positions}, {"NORMAL", parts.positions({0, 0, 1, 0, 0, 1, 0, 0, 1})}});
  return parts;
}

/// Indices of one byte each.
inline Bytes bytes_of(const std::vector<std::uint32_t>& indices) {
  Bytes bytes;
  for (const std::uint32_t index : indices) bytes.u8(index);
  return bytes;
}

inline ReadFile read(const GlbParts& parts, const ImportLimits& limits = {}) {
  return ReadFile(read_glb_mesh(parts.glb(), limits));
}

inline std::string refusal_of(const GlbParts& parts, const ImportLimits& limits = {}) {
  return refusal(read_glb_mesh, parts.glb(), limits);
}

}  // namespace dini::support

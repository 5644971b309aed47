#pragma once

#include <vector>

#include "geometry/face_builder.h"
#include "gltf/gltf_primitive.h"

namespace dini {

/// Where the vertices of a mesh stand.
struct GltfPlace {
  Affine node;                                ///< of the node that shows it
  const std::vector<Affine>* pose = nullptr;  ///< of its skin; the node's map does not count then
};

/// Adds primitives of a glTF to a raw mesh, each as often as nodes show it. Only vertices that triangles use are taken.
class GlbMeshBuilder {
 public:
  GlbMeshBuilder(GltfDocument& document, const ImportLimits& limits, const Cancel& cancel)
      : document_(document), limits_(limits), cancel_(cancel) {}

  /// Points and lines are counted, and no more. `name` tells a warning where the primitive stands.
  void add(const GltfJson& primitive, const GltfPlace& place, const std::string& name);

  /// The mesh and what was left out of it; to be called once, at the end.
  RawMesh finish();

 private:
  void add_vertices(const GltfPrimitive& primitive, const std::vector<std::uint32_t>& vertices, const GltfPlace& place,
                    std::vector<bool>& mirrored);
  void add_attributes(const GltfPrimitive& primitive, std::uint32_t vertex, const Affine& map);

  GltfDocument& document_;
  const ImportLimits& limits_;
  const Cancel& cancel_;
  RawMesh raw_;
  FaceBuilder faces_;
  std::size_t points_and_lines_ = 0, without_area_ = 0, smooth_ = 0, cut_away_ = 0;
  bool any_uv_ = false, any_color_ = false;
};

}  // namespace dini

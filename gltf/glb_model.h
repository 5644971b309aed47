#pragma once

#include <map>
#include <string>
#include <tiny_gltf.h>
#include <utility>
#include <vector>

#include "geometry/scene.h"
#include "gltf/lines.h"
#include "gltf/mesh_encoder.h"

namespace dini {

/// A glTF model while it grows: one node and mesh per part under one root that turns Z up into glTF's Y up.
class GlbModel {
 public:
  explicit GlbModel(const std::string& generator);

  /// Starts the node and mesh of the next part; the primitives that follow belong to it.
  void begin_part(const std::string& name);

  /// A compressed tile, given its exact decoded bounds. A tile with vertex colors takes white as its material color.
  void add_tile(const EncodedTile& tile, const FloatBox& bounds, const Color& color, bool translucent);

  /// Polylines: one LINE_STRIP each; beyond 64 of them one LINES primitive, which viewers draw in one call.
  void add_runs(const std::vector<FloatPoints>& runs, const Color& color);

  /// One POINTS primitive; `points` is not empty.
  void add_points(const FloatPoints& points, const Color& color);

  /// Bytes of binary data so far.
  std::size_t binary_size() const { return model_.buffers[0].data.size(); }

  /// The finished file; an empty string if tinygltf refuses. Throws what tinygltf throws.
  std::string write();

 private:
  int add_bytes(const void* data, std::size_t size, int target);
  int add_accessor(tinygltf::Accessor accessor);
  int add_material(const Color& color, bool translucent);
  int add_positions(int view, std::size_t offset, std::size_t count, const FloatBox& box);
  void add_primitive(int mode, int positions, int indices, int material);
  std::vector<tinygltf::Primitive>& primitives() { return model_.meshes.back().primitives; }

  tinygltf::Model model_;
  std::map<std::pair<Color, bool>, int> materials_;
};

}  // namespace dini

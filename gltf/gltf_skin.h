#pragma once

#include <vector>

#include "gltf/gltf_nodes.h"

namespace dini {

/// The joints of a skin in the pose that the nodes of the file stand in: for each the map from where the mesh was bound
/// to the world, its global transform after its inverse bind matrix.
std::vector<Affine> pose_of(GltfDocument& document, GltfNodes& nodes, std::size_t skin);

/// The joints and weights of a primitive's vertices.
class GltfWeights {
 public:
  GltfWeights() = default;
  /// At most four sets of four joints each; the accessors are those of `attributes`, with `count` values.
  GltfWeights(GltfDocument& document, const GltfJson& attributes, std::size_t count);

  bool empty() const { return sets_.empty(); }

  /// The mean of the joints' maps at a vertex, by its weights, which need not add up to 1. A vertex without weights
  /// follows the first of its joints. Refuses a joint that the pose does not have.
  Affine place(const std::vector<Affine>& pose, std::size_t vertex) const;

 private:
  struct Set {
    const GltfAccessor* joints = nullptr;
    const GltfAccessor* weights = nullptr;
  };

  std::vector<Set> sets_;
};

}  // namespace dini

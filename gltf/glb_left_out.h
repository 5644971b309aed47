#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "gltf/gltf_document.h"

namespace dini {

/// Counts what of a GLB is not in the mesh that is made of it, apart from what its primitives leave out.
class GlbLeftOut {
 public:
  /// Whether a node hides itself and all below it (KHR_node_visibility).
  bool is_hidden(const GltfJson& node);

  /// A mesh that is shown by a node.
  void add_mesh(std::size_t index, const GltfJson& mesh, const GltfJson& node);

  /// Adds a sentence to the warnings for each kind that was met.
  void warn(const GltfDocument& document, std::vector<std::string>& warnings) const;

 private:
  std::set<std::size_t> shown_;
  std::size_t hidden_ = 0, attributes_ = 0, morphed_ = 0, instanced_ = 0;
};

}  // namespace dini

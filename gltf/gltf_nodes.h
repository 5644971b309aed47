#pragma once

#include <optional>
#include <vector>

#include "gltf/affine.h"
#include "gltf/gltf_document.h"

namespace dini {

/// The map of a node's own transform: a matrix by columns, or scale, then turn, then shift.
Affine transform_of(const GltfJson& node);

/// A map of 16 numbers, by columns; the last row does not count.
Affine affine_from(const std::array<double, 16>& columns);

/// Where the nodes of a document stand in the world.
class GltfNodes {
 public:
  explicit GltfNodes(const GltfDocument& document);

  /// Nodes that are no child of another.
  std::vector<std::size_t> roots() const;

  /// The map of a node and all above it. Refuses nodes that go round in a circle.
  Affine world(std::size_t node);

 private:
  const GltfDocument& document_;
  std::vector<std::optional<std::size_t>> parents_;
  std::vector<std::optional<Affine>> worlds_;
};

}  // namespace dini

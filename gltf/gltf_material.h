#pragma once

#include <array>

#include "gltf/gltf_document.h"

namespace dini {

/// What a material does to the colors of vertices: it multiplies them, and its alpha mode says what their alpha means.
/// Textures have no part in it.
class GltfMaterial {
 public:
  /// Of a primitive; without a material white and opaque.
  static GltfMaterial of(const GltfDocument& document, const GltfJson& primitive);

  /// The color of a vertex whose own color is `own`: its alpha is 1 under OPAQUE, which is the default, 1 or 0 under
  /// MASK, where it is compared with the cutoff, and the product itself under BLEND. What is not finite stays so.
  std::array<float, 4> color(const std::array<double, 4>& own) const;

  /// Whether MASK makes such a vertex invisible.
  bool cuts_away(const std::array<double, 4>& own) const { return mode_ == AlphaMode::mask && color(own)[3] == 0; }

  /// Whether vertices without a color of their own come out white and opaque.
  bool is_plain() const { return color({1, 1, 1, 1}) == std::array<float, 4>{1, 1, 1, 1}; }

 private:
  enum class AlphaMode { opaque, mask, blend };

  std::array<double, 4> base_ = {1, 1, 1, 1};
  AlphaMode mode_ = AlphaMode::opaque;
  double cutoff_ = 0.5;
};

}  // namespace dini

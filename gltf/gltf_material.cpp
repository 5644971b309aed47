#include "gltf/gltf_material.h"

#include <algorithm>
#include <cmath>

#include "gltf/gltf_extensions.h"

namespace dini {

namespace {

std::array<double, 4> base_color(const GltfJson& material) {
  constexpr std::array<double, 4> white = {1, 1, 1, 1};
  if (const GltfJson* surface = object_member(material, "pbrMetallicRoughness")) {
    return number_list<4>(*surface, "baseColorFactor").value_or(white);
  }
  const GltfJson* older = extension_of(material, specular_glossiness_extension);
  return older == nullptr ? white : number_list<4>(*older, "diffuseFactor").value_or(white);
}

}  // namespace

GltfMaterial GltfMaterial::of(const GltfDocument& document, const GltfJson& primitive) {
  GltfMaterial material;
  const auto index = whole_number(primitive, "material");
  if (!index) return material;
  const GltfJson& description = document.entry("materials", *index);
  material.base_ = base_color(description);
  for (double& channel : material.base_) channel = std::clamp(channel, 0.0, 1.0);
  const std::string mode = text_member(description, "alphaMode", "OPAQUE");
  if (mode != "OPAQUE" && mode != "MASK" && mode != "BLEND") {
    refuse_gltf("material " + std::to_string(*index) + ": \"alphaMode\" must be OPAQUE, MASK or BLEND");
  }
  material.mode_ = mode == "MASK" ? AlphaMode::mask : mode == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
  const auto cutoff = description.find("alphaCutoff");
  if (cutoff != description.end() && cutoff->is_number()) material.cutoff_ = cutoff->get<double>();
  return material;
}

std::array<float, 4> GltfMaterial::color(const std::array<double, 4>& own) const {
  std::array<float, 4> color{};
  for (std::size_t k = 0; k < 4; ++k) color[k] = static_cast<float>(own[k] * base_[k]);
  if (!std::isfinite(color[3]) || mode_ == AlphaMode::blend) return color;
  color[3] = mode_ == AlphaMode::opaque || own[3] * base_[3] >= cutoff_ ? 1 : 0;
  return color;
}

}  // namespace dini

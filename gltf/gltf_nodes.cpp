#include "gltf/gltf_nodes.h"

namespace dini {

Affine affine_from(const std::array<double, 16>& columns) {
  const auto column = [&](std::size_t k) { return Vector{columns[4 * k], columns[4 * k + 1], columns[4 * k + 2]}; };
  return {{column(0), column(1), column(2)}, column(3)};
}

Affine transform_of(const GltfJson& node) {
  if (const auto matrix = number_list<16>(node, "matrix")) return affine_from(*matrix);
  const auto scale = number_list<3>(node, "scale").value_or(std::array<double, 3>{1, 1, 1});
  const auto shift = number_list<3>(node, "translation").value_or(std::array<double, 3>{0, 0, 0});
  const auto q = number_list<4>(node, "rotation").value_or(std::array<double, 4>{0, 0, 0, 1});
  const Vector axis = {q[0], q[1], q[2]};
  const double w = q[3];
  const auto turned = [&](const Vector& v) {
    const Vector t = 2 * cross(axis, v);
    return v + w * t + cross(axis, t);
  };
  return {{turned({scale[0], 0, 0}), turned({0, scale[1], 0}), turned({0, 0, scale[2]})},
          {shift[0], shift[1], shift[2]}};
}

GltfNodes::GltfNodes(const GltfDocument& document)
    : document_(document), parents_(document.count("nodes")), worlds_(parents_.size()) {
  for (std::size_t i = 0; i < parents_.size(); ++i) {
    for (const std::size_t child : index_list(document.entry("nodes", i), "children")) {
      if (child < parents_.size()) parents_[child] = i;
    }
  }
}

std::vector<std::size_t> GltfNodes::roots() const {
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < parents_.size(); ++i) {
    if (!parents_[i]) roots.push_back(i);
  }
  return roots;
}

Affine GltfNodes::world(std::size_t node) {
  std::vector<std::size_t> chain;
  std::optional<std::size_t> above = node;
  for (; above && !worlds_[*above]; above = parents_[*above]) {
    if (chain.size() == parents_.size()) refuse_gltf("node " + std::to_string(node) + " stands above itself");
    chain.push_back(*above);
  }
  Affine place = above ? *worlds_[*above] : Affine{};
  for (std::size_t k = chain.size(); k-- > 0;) {
    place = after(place, transform_of(document_.entry("nodes", chain[k])));
    worlds_[chain[k]] = place;
  }
  return place;
}

}  // namespace dini

#include "gltf/gltf_skin.h"

#include <cmath>

namespace dini {

namespace {

constexpr std::size_t most_sets = 4;

void add_weighted(Affine& sum, double weight, const Affine& map) {
  for (std::size_t k = 0; k < 3; ++k) sum.linear[k] = sum.linear[k] + weight * map.linear[k];
  sum.shift = sum.shift + weight * map.shift;
}

}  // namespace

std::vector<Affine> pose_of(GltfDocument& document, GltfNodes& nodes, std::size_t skin) {
  const GltfJson& description = document.entry("skins", skin);
  const std::vector<std::size_t> joints = index_list(description, "joints");
  const auto inverse = whole_number(description, "inverseBindMatrices");
  const GltfAccessor* matrices = inverse ? &document.accessor(*inverse) : nullptr;
  if (matrices != nullptr && (matrices->width() != 16 || !matrices->is_real() || matrices->count() < joints.size())) {
    refuse_gltf("skin " + std::to_string(skin) + ": its inverse bind matrices are not one for each joint");
  }
  document.spend(joints.size());
  std::vector<Affine> pose;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    document.entry("nodes", joints[i]);
    pose.push_back(nodes.world(joints[i]));
    if (matrices == nullptr) continue;
    std::array<double, 16> numbers{};
    for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = matrices->number(i, k);
    pose.back() = after(pose.back(), affine_from(numbers));
  }
  return pose;
}

GltfWeights::GltfWeights(GltfDocument& document, const GltfJson& attributes, std::size_t count) {
  for (std::size_t set = 0; set <= most_sets; ++set) {
    const auto joints = whole_number(attributes, ("JOINTS_" + std::to_string(set)).c_str());
    const auto weights = whole_number(attributes, ("WEIGHTS_" + std::to_string(set)).c_str());
    if (!joints && !weights) return;
    if (set == most_sets) refuse_gltf("a vertex has more than 16 joints");
    if (!joints || !weights) refuse_gltf("joints and weights do not come together");
    sets_.push_back({&document.accessor(*joints), &document.accessor(*weights)});
    for (const GltfAccessor* accessor : {sets_.back().joints, sets_.back().weights}) {
      if (accessor->width() != 4 || accessor->count() != count)
        refuse_gltf("joints or weights are not four per vertex");
    }
  }
}

Affine GltfWeights::place(const std::vector<Affine>& pose, std::size_t vertex) const {
  Affine sum = {{Vector{}, Vector{}, Vector{}}, {}};
  double total = 0;
  const auto joint = [&](const Set& set, std::size_t k) -> const Affine& {
    const double index = set.joints->number(vertex, k);
    if (index >= 0 && index < static_cast<double>(pose.size())) return pose[static_cast<std::size_t>(index)];
    refuse_gltf("a vertex follows a joint that its skin does not have");
  };
  for (const Set& set : sets_) {
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = set.weights->number(vertex, k);
      if (weight == 0) continue;
      add_weighted(sum, weight, joint(set, k));
      total += weight;
    }
  }
  if (total == 0) return joint(sets_.front(), 0);
  for (Vector& column : sum.linear) column = column / total;
  sum.shift = sum.shift / total;
  return sum;
}

}  // namespace dini

#pragma once

// The models of many variants in one file.

#include <cstddef>
#include <string>
#include <vector>

#include "service/engine.h"

namespace dini {

/// A model of a variant: a GLB.
struct NamedModel {
  std::string output;  ///< empty where the variant has this one only
  SharedFile model;
};

/// The models of one variant.
struct VariantModel {
  std::size_t index = 0;
  Json setting;  ///< its values by parameter
  std::vector<NamedModel> models;
};

/// A GLB with a node for each variant, which is called as its values ("reach=0.5, rule=paper") and has `index` and
/// `parameters` in its extras. Below it is its model or, where models are named, a node of each output's name with that
/// output's model. Equal models share meshes. `fixed` are the parameters that all have in
/// common. A problem `limit-exceeded` when it would be larger than a GLB can be.
Result<SharedFile> variant_file(const std::vector<VariantModel>& variants, const Graph& graph, const Json& fixed);

}  // namespace dini

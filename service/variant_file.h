#pragma once

// The models of many variants in one file.

#include <cstddef>
#include <vector>

#include "service/engine.h"

namespace dini {

/// The model of one variant: a GLB.
struct VariantModel {
  std::size_t index = 0;
  Json setting;  ///< its values by parameter
  SharedFile model;
};

/// A GLB with a node for each variant, which is called as its values ("reach=0.5, rule=paper") and has `index` and
/// `parameters` in its extras; variants of equal models share meshes. `fixed` are the parameters that all have in
/// common. A problem `limit-exceeded` when it would be larger than a GLB can be.
Result<SharedFile> variant_file(const std::vector<VariantModel>& variants, const Graph& graph, const Json& fixed);

}  // namespace dini

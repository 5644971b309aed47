#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/expected.h"
#include "golden/model_facts.h"

namespace dini {

/// A model of any program, and sentences about what its file has and it has not, such as curves.
struct AnyModel {
  Model model;
  std::vector<std::string> left_out = {};
};

/// Reads a GLB from anyone: one of ours with Draco by its own reader, and any other as `import` does, so its triangles
/// only. The error is a sentence: what is compressed by other programs, or is damaged, is not read.
Expected<AnyModel, std::string> read_any_model(std::string_view glb);

}  // namespace dini

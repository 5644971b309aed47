#pragma once

#include <string>
#include <vector>

#include "fitting/matrix.h"
#include "fitting/varied.h"

namespace dini::fitting {

/// Parameters that what was asked does not determine: along this direction they change together, and nothing else does.
struct Undetermined {
  std::vector<std::string> parameters;
  std::string detail;  ///< one sentence
};

/// Reads them from how sharply the sum of squares rises (`normal_matrix`): a direction counts when going through all
/// of it changes what is asked by less than a ten-thousandth of its size.
std::vector<Undetermined> undetermined_by(const SymmetricMatrix& rise, const std::vector<Varied>& varied);

}  // namespace dini::fitting

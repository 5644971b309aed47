#pragma once

#include "algebra/kernels.h"

namespace dini::kernels {

/// True when the generator is the null pair at the position of the source, to the round-off of its coefficients.
bool is_null_pair(const WarpSource& source);

}  // namespace dini::kernels

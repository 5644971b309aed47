#pragma once

#include <string_view>

#include "graph/asset_file.h"
#include "graph/limits.h"
#include "graph/problem.h"

namespace dini {

/// Reads a mesh file whose format its first bytes tell: GLB, PLY, else OBJ if it is text. Problems: `invalid-asset`,
/// and `limit-exceeded` for a file beyond the limits.
Result<SharedAssetFile> read_asset(std::string_view bytes, const Limits& limits);

}  // namespace dini

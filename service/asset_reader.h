#pragma once

#include <string_view>

#include "geometry/cancel.h"
#include "graph/asset_file.h"
#include "graph/limits.h"
#include "graph/problem.h"

namespace dini {

/// Reads a mesh file whose format its first bytes tell, behind a byte order mark or not: GLB, PLY, else OBJ if it is
/// text. The result has no `source`. Problems: `invalid-asset`, `limit-exceeded` for a file beyond the limits, and what
/// `cancel` says when it stops the reading.
Result<std::shared_ptr<AssetFile>> read_asset(std::string_view bytes, const Limits& limits, const Cancel& cancel);

}  // namespace dini

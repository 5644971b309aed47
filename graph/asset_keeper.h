#pragma once

#include <string_view>

#include "graph/digest.h"
#include "graph/file.h"
#include "graph/problem.h"

namespace dini {

/// Where uploaded files are kept besides the meshes that were read from them, so that they outlive the process. Safe to
/// use from many threads.
class AssetKeeper {
 public:
  virtual ~AssetKeeper() = default;

  /// Keeps a file of that hash. Problems: `storage-full`, `storage-failed`.
  virtual Result<bool> keep(const Digest& sha256, std::string_view bytes) = 0;

  /// The bytes of that hash; null when they are not here or are not what was written. Counts as a use.
  virtual SharedBytes find(const Digest& sha256) = 0;

  /// Counts as a use of a file whose mesh is still in memory.
  virtual void note_use(const Digest& sha256) = 0;
};

}  // namespace dini

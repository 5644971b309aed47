#pragma once

#include "graph/cache.h"
#include "graph/file.h"

namespace dini::server {

/// Files that were made, to be fetched by their hash as long as there is room for them.
class Artifacts {
 public:
  explicit Artifacts(std::size_t budget) : files_(budget) {}

  void add(const SharedFile& file);
  /// Null when it is not kept.
  SharedFile find(const Digest& sha256);
  void clear() { files_.clear(); }

 private:
  Cache files_;
};

/// The address of a file.
std::string artifact_address(const File& file);

}  // namespace dini::server

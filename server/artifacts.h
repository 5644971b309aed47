#pragma once

#include <string_view>

#include "graph/cache.h"
#include "graph/file.h"

namespace dini::server {

/// Files that were made, to be fetched by their hash as long as there is room for them.
class Artifacts {
 public:
  explicit Artifacts(std::size_t budget) : files_(budget) {}

  void add(const SharedFile& file);
  /// By its hash as it is written in an address; null when it is not kept.
  SharedFile find(std::string_view sha256);
  void clear() { files_.clear(); }

 private:
  Cache files_;
};

}  // namespace dini::server

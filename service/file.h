#pragma once

#include <memory>
#include <string>

#include "graph/digest.h"

namespace dini {

/// Bytes that never change, so that everybody who needs them can hold the same ones.
using SharedBytes = std::shared_ptr<const std::string>;

inline SharedBytes share(std::string bytes) { return std::make_shared<const std::string>(std::move(bytes)); }

/// A finished file: what an export makes.
struct File {
  std::string media_type;
  std::string extension;  ///< with its period
  SharedBytes bytes;
  Digest sha256{};
};

using SharedFile = std::shared_ptr<const File>;

}  // namespace dini

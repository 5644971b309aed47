#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "geometry/file_format.h"
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
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  double position_error = 0;  ///< meters: no point in the file is farther from its original
  std::optional<AttributeErrors> attribute_errors = {};
};

using SharedFile = std::shared_ptr<const File>;

/// How the file of an export is wanted: known when a graph is evaluated for an answer, not when it is written.
struct WantedFile {
  const FileFormat* format = nullptr;   ///< of the engine's, which outlives every plan
  Json about = nullptr;                 ///< what the file says about itself
  bool draco = true;                    ///< false: meshes are not compressed, whatever the node says
  TopologyCache* topologies = nullptr;  ///< the engine's, which outlives every plan too
};

}  // namespace dini

#pragma once

// Files whose parts stand in named groups: what previews are written as.

#include <string>
#include <vector>

#include "geometry/cancel.h"
#include "geometry/json.h"
#include "geometry/scene.h"
#include "gltf/encode_error.h"
#include "gltf/encode_options.h"

namespace dini {

/// One thing below a group: its parts become the primitives of one mesh.
struct GlbChild {
  std::string name;
  Json extras;
  std::vector<Part> parts;  ///< their names do not count
};

/// A node without a mesh of its own.
struct GlbGroup {
  std::string name;
  Json extras;  ///< an object; a group with nothing to draw gets the member "drawable": false
  std::vector<GlbChild> children;
};

/// Writes groups as `encode_scene` writes parts, one node for each group and below it one for each child that has
/// something to draw. Groups that have none stay as empty nodes, so nothing at all to draw is no error. Errors name the
/// group at fault.
EncodeResult<std::string> encode_groups(const std::vector<GlbGroup>& groups, const EncodeOptions& options,
                                        const Cancel& cancel);

}  // namespace dini

#pragma once

// Several GLBs in one, a node for each.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/json.h"

namespace dini {

/// One of the files that are put together, or several of them below one node.
struct GlbItem {
  std::string name;           ///< of its node
  Json extras;                ///< of its node; null for none
  std::string_view glb = {};  ///< as `encode_scene` writes it: with Draco or without, no textures, skins or animations
  std::vector<GlbItem> items = {};  ///< instead of a file: those below its node, each with a file
};

/// A GLB with a node for each item, in their order, and what the item's scene holds below it. Items of the same bytes
/// share meshes. `about` becomes `asset.extras`. Nothing when an item is no such file, or when all are more than a GLB
/// can address.
std::optional<std::string> assemble_glb(std::span<const GlbItem> items, const Json& about);

}  // namespace dini

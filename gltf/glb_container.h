#pragma once

// The GLB container: a header, a JSON chunk, and a binary chunk.

#include <optional>
#include <string>
#include <string_view>

namespace dini {

/// The two chunks of a GLB, viewing into it. `binary` is empty when there is no binary chunk.
struct GlbChunks {
  std::string_view json;    ///< with its trailing spaces
  std::string_view binary;  ///< with its trailing zeros
  std::size_t behind = 0;   ///< bytes that follow the length in its header: they are no part of the file
};

/// Nothing if `glb` is not a complete GLB of version 2. Chunks of other types than these two are passed over.
std::optional<GlbChunks> split_glb(std::string_view glb);

/// A GLB of a JSON chunk and a binary chunk, which is left out when it is empty. Empty when it would be larger than GLB
/// can address.
std::string join_glb(std::string_view json, std::string_view binary);

}  // namespace dini

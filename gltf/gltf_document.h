#pragma once

// The JSON of a glTF from outside, and numbers out of its binary chunk: every member is checked before it is used.

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "geometry/imported_mesh.h"

namespace dini {

using GltfJson = nlohmann::json;

/// Thrown inside the reader of GLB files only, which turns it into its result: a file is refused from deep inside of
/// it, and left when the cancel flag is set.
struct GltfRefused {
  ImportError error;
};

/// The glTF document of a GLB. Members that are missing, of a wrong type or out of range throw GltfRefused.
class GltfDocument {
 public:
  /// At most 4 MiB of JSON, 64 levels deep, with 500,000 values.
  GltfDocument(std::string_view glb, const Cancel& cancel);

  const GltfJson& root() const { return root_; }

  /// Entry `index` of the array `name` at the top: an object.
  const GltfJson& entry(const char* name, std::size_t index) const;
  std::size_t count(const char* name) const;

  /// The values of an accessor, `width` numbers for each. Integers that stand for shares of 1 become those.
  std::vector<double> numbers(std::size_t accessor, std::size_t width) const;
  /// Like `numbers`, for accessors of three or four components: their own width.
  std::vector<double> colors(std::size_t accessor, std::size_t& width) const;
  /// At most `most` of them: one byte in the file becomes twelve in memory.
  std::vector<std::uint32_t> indices(std::size_t accessor, std::size_t most) const;
  std::size_t accessor_count(std::size_t accessor) const;

 private:
  /// Where the values of an accessor lie, all of them inside the binary chunk.
  struct Layout {
    std::string_view bytes;
    std::size_t count = 0, stride = 0, width = 0, component = 0;
    std::uint64_t type = 0;
    bool normalized = false;
  };

  Layout layout(std::size_t accessor) const;
  std::vector<double> read(const Layout& layout) const;

  GltfJson root_;
  std::string_view binary_;
  const Cancel& cancel_;
};

[[noreturn]] void refuse_gltf(std::string detail);

/// A member that is a whole number from 0; nothing when it is missing.
std::optional<std::size_t> whole_number(const GltfJson& object, const char* name);
/// A member that must be there.
std::size_t needed_number(const GltfJson& object, const char* name);
/// N finite numbers; nothing when the member is missing.
template <std::size_t N>
std::optional<std::array<double, N>> number_list(const GltfJson& object, const char* name);
/// Whole numbers from 0; empty when the member is missing.
std::vector<std::size_t> index_list(const GltfJson& object, const char* name);

}  // namespace dini

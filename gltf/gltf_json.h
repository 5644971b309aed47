#pragma once

// Members of the JSON of a glTF from outside: each is checked before it is used.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/imported_mesh.h"
#include "geometry/json.h"

namespace dini {

using GltfJson = Json;

/// Thrown inside the reader of GLB files only, which turns it into its result: a file is refused from deep inside of
/// it, and left when the cancel flag is set.
struct GltfRefused {
  ImportError error;
};

[[noreturn]] void refuse_gltf(std::string detail);

/// Refuses JSON of more than 4 MiB, 500,000 values or 64 levels before anything is built of it, and JSON that is no
/// object.
GltfJson parse_gltf(std::string_view json);

/// A member that is an object; nothing when it is missing or something else.
const GltfJson* object_member(const GltfJson& object, const char* name);
/// A member that is a whole number from 0; nothing when it is missing.
std::optional<std::size_t> whole_number(const GltfJson& object, const char* name);
/// A member that must be there.
std::size_t needed_number(const GltfJson& object, const char* name);
/// N finite numbers; nothing when the member is missing.
template <std::size_t N>
std::optional<std::array<double, N>> number_list(const GltfJson& object, const char* name);
/// Whole numbers from 0; empty when the member is missing.
std::vector<std::size_t> index_list(const GltfJson& object, const char* name);
/// The text of a member, or `missing` where it is missing.
std::string text_member(const GltfJson& object, const char* name, std::string_view missing);
/// Whether a member is true.
bool is_true(const GltfJson& object, const char* name);
/// The extension of an object; nothing when it has none of that name.
const GltfJson* extension_of(const GltfJson& object, const char* name);

}  // namespace dini

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/imported_mesh.h"

namespace dini {

enum class PlyEncoding { ascii, little_endian, big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::size_t size_of(PlyType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

constexpr bool is_integer(PlyType type) { return type < PlyType::float32; }

/// One value of each item of an element, or a list of them with its length before it.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> length;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;  ///< as the file claims
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;   ///< bytes up to the data
  std::size_t lines = 0;  ///< of the header
};

/// Whether bytes begin like a PLY: with a line "ply", a byte order mark before it or not.
bool begins_like_ply(std::string_view bytes);

/// Reads the header of a PLY 1.0. At most 16 elements with 64 properties each, 64 KiB in all; every element has
/// properties, and its count is not more than the bytes after the header could hold. Words count the same in capital
/// letters, and come out in small ones.
Expected<PlyHeader, ImportError> read_ply_header(std::string_view bytes);

}  // namespace dini

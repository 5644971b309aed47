#pragma once

// What files say about themselves, and numbers and colors as they are written.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "formats/plain_scene.h"

namespace dini {

/// "Dini 0.2.0".
std::string program_of(const FileOptions& options);

/// What the file says about itself, as one line of JSON in ASCII; with or without the graph that may be in it. Empty
/// where there is nothing to say.
std::string about_line(const FileOptions& options, bool with_graph);

/// Appends the shortest text that reads as the same float.
void append_number(std::string& text, float value);

/// Appends a whole number.
void append_count(std::string& text, std::size_t value);

/// Appends the bytes of a value, the low one first.
template <class Value>
void append_bytes(std::string& bytes, const Value& value) {
  static_assert(std::endian::native == std::endian::little);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// Red, green, blue and alpha as pictures store them (sRGB), 255 for 1.
using PictureColor = std::array<std::uint8_t, 4>;

PictureColor picture_color(const Color& linear);

/// The colors of a part's vertices: their own, or for all the color of the part.
class VertexColors {
 public:
  explicit VertexColors(const PlainPart& part);

  PictureColor operator[](std::size_t vertex) const;

 private:
  const PlainPart& part_;
  PictureColor of_part_;
  std::vector<std::uint8_t> shares_;  ///< for each value that a channel of a tile has: see `Tile`
};

}  // namespace dini

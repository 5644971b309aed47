#pragma once

namespace dini {

/// Tiles that are compressed at once at most, whatever threads there are: each needs some megabytes.
inline constexpr int most_tiles_at_once = 16;

/// What is drawn into a file, in numbers.
struct DrawnSizes {
  double meshes = 0;
  double vertices = 0;  ///< of all meshes; each vertex has at most two triangles
  double curves = 0;
  double curve_points = 0;
  double points = 0;
};

/// What writing a file needs: work in nanoseconds of one processor, about; bounds of the bytes while it is written,
/// and of the file.
struct EncodeCost {
  double work = 0;
  double bytes = 0;
  double file_bytes = 0;
};

/// The cost of `encode_scene` at a Draco speed of 0 to 10, or without Draco.
EncodeCost encode_cost(const DrawnSizes& sizes, int speed, bool draco = true);

}  // namespace dini

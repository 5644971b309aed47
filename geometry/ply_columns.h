#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/file_colors.h"
#include "geometry/ply_header.h"

namespace dini {

/// What a property of a vertex or a face means to us.
enum class PlyMeaning { other, x, y, z, nx, ny, nz, u, v, red, green, blue, alpha, corners };

inline constexpr std::size_t ply_meanings = 14;

/// The numbers of one vertex or face, by their meaning.
struct PlyNumbers {
  std::array<double, ply_meanings> values{};

  double& operator[](PlyMeaning meaning) { return values[static_cast<std::size_t>(meaning)]; }
  double operator[](PlyMeaning meaning) const { return values[static_cast<std::size_t>(meaning)]; }
};

/// Which properties of an element are read, by the names in use: x; nx; s, u or texture_u; red, r or diffuse_red; the
/// list vertex_indices or vertex_index; and so on. A group counts only when it is complete: x y z, nx ny nz, u v, red
/// green blue (with alpha or without); of two properties with the same meaning the first one does.
class PlyColumns {
 public:
  static PlyColumns of_vertices(const PlyElement& element);
  static PlyColumns of_faces(const PlyElement& element, bool with_colors);

  PlyMeaning operator[](std::size_t property) const { return meanings_[property]; }
  bool has(PlyMeaning meaning) const { return type_of(meaning).has_value(); }

  /// Names the properties that are not read, in a sentence; nothing when there are none.
  std::optional<std::string> left_out(const PlyElement& element) const;

  /// The color in a row, before its scale is known.
  std::array<float, 4> color(const PlyNumbers& row) const;
  /// What may stand for full light or an opaque alpha, by the type of such a channel.
  FullValue full_value(PlyMeaning channel) const;

 private:
  explicit PlyColumns(const PlyElement& element);

  const std::optional<PlyType>& type_of(PlyMeaning meaning) const { return types_[static_cast<std::size_t>(meaning)]; }
  void drop(PlyMeaning first, PlyMeaning last);

  std::vector<PlyMeaning> meanings_;
  std::array<std::optional<PlyType>, ply_meanings> types_;
};

}  // namespace dini

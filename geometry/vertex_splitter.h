#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/key_numbers.h"
#include "geometry/raw_mesh.h"

namespace dini {

/// Makes several vertices out of one where the faces around it want different values of an attribute there.
class VertexSplitter {
 public:
  /// What tells values of the attribute apart.
  using Value = std::array<std::uint32_t, 4>;

  /// For the vertices from `first` on of a mesh that has `vertices` so far.
  VertexSplitter(std::size_t first, std::size_t vertices)
      : first_(first), vertices_(vertices), has_value_(vertices - first) {}

  /// The vertex that stands for `vertex` with a value: itself with the first value it is asked for, a copy with every
  /// other one. Copies are numbered from `vertices` on.
  std::uint32_t at(std::uint32_t vertex, const Value& value);

  std::size_t copies() const { return sources_.size(); }

  /// Adds the copies to the mesh, with all that their vertices have.
  void append_copies(RawMesh& raw) const;

 private:
  std::size_t first_, vertices_;
  std::vector<bool> has_value_;
  KeyNumbers<5> known_;                 ///< pairs of a vertex and a value
  std::vector<std::uint32_t> targets_;  ///< the vertex for each of them
  std::vector<std::uint32_t> sources_;  ///< of the copies
};

}  // namespace dini

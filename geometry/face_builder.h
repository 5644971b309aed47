#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "geometry/raw_mesh.h"

namespace dini {

/// Turns the faces of a file into triangles, and counts those that cannot be drawn.
class FaceBuilder {
 public:
  /// Whether a face can be drawn: it has three corners or more, all of them finite and below 1e18. One that cannot is
  /// counted, to be told of by `warn`; `place` says where the first of its kind stands.
  template <class Place>
  bool takes(std::span<const Vector> corners, const Place& place) {
    LeftOut* const kind = fault_of(corners);
    if (kind != nullptr && kind->count++ == 0) kind->first = place();
    return kind == nullptr;
  }

  /// Adds the triangles of a face that was taken; `vertices` are those of `raw` at its corners. Triangles that use a
  /// vertex twice are counted and left out.
  void add(std::span<const std::uint32_t> vertices, std::span<const Vector> corners, RawMesh& raw);
  void count_repeated(std::size_t triangles) { repeated_ += triangles; }

  /// Adds a sentence to the warnings for each kind of face or triangle that was left out.
  void warn(std::vector<std::string>& warnings) const;

 private:
  struct LeftOut {
    std::size_t count = 0;
    std::string first;
  };

  LeftOut* fault_of(std::span<const Vector> corners);

  PolygonCutter cutter_;
  std::vector<std::array<std::uint32_t, 3>> pieces_;
  LeftOut short_, out_of_reach_;
  std::size_t repeated_ = 0;
};

}  // namespace dini

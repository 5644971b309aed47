#include "geometry/face_builder.h"

#include <algorithm>

#include "geometry/counted.h"
#include "geometry/validate.h"

namespace dini {

FaceBuilder::LeftOut* FaceBuilder::fault_of(std::span<const Vector> corners) {
  if (corners.size() < 3) return &short_;
  const bool reached =
      std::all_of(corners.begin(), corners.end(), [](const Vector& p) { return is_within_reach(to_point(p)); });
  return reached ? nullptr : &out_of_reach_;
}

void FaceBuilder::add(std::span<const std::uint32_t> vertices, std::span<const Vector> corners, RawMesh& raw) {
  pieces_.clear();
  cutter_.cut(corners, pieces_);
  for (const auto& piece : pieces_) {
    const auto a = vertices[piece[0]], b = vertices[piece[1]], c = vertices[piece[2]];
    if (a == b || b == c || c == a) {
      ++repeated_;
    } else {
      raw.triangles.push_back({a, b, c});
    }
  }
}

void FaceBuilder::warn(std::vector<std::string>& warnings) const {
  const auto tell = [&](const LeftOut& kind, std::string_view one, std::string_view many) {
    if (kind.count > 0) warnings.push_back(counted(kind.count, one, many) + " left out, the first at " + kind.first);
  };
  tell(short_, "face has fewer than three corners and is", "faces have fewer than three corners and are");
  tell(out_of_reach_, "face uses a vertex that is not finite or beyond 1e18 and is",
       "faces use a vertex that is not finite or beyond 1e18 and are");
  if (repeated_ > 0) {
    warnings.push_back(
        counted(repeated_, "triangle uses a vertex twice and is", "triangles use a vertex twice and are") +
        " left out");
  }
}

}  // namespace dini

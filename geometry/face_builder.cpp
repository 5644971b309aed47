#include "geometry/face_builder.h"

#include <algorithm>

#include "geometry/validate.h"

namespace dini {

bool FaceBuilder::takes(std::span<const Vector> corners) {
  if (corners.size() < 3) {
    ++too_short_;
    return false;
  }
  const bool reached =
      std::all_of(corners.begin(), corners.end(), [](const Vector& p) { return is_within_reach(to_point(p)); });
  out_of_reach_ += reached ? 0 : 1;
  return reached;
}

void FaceBuilder::add(std::span<const std::uint32_t> vertices, std::span<const Vector> corners, RawMesh& raw) {
  pieces_.clear();
  cutter_.cut(corners, pieces_);
  for (const auto& [a, b, c] : pieces_) raw.triangles.push_back({vertices[a], vertices[b], vertices[c]});
}

void FaceBuilder::warn(std::vector<std::string>& warnings) const {
  if (too_short_ > 0) {
    warnings.push_back(counted(too_short_, "face has fewer than three corners and is left out",
                               "faces have fewer than three corners and are left out"));
  }
  if (out_of_reach_ > 0) {
    warnings.push_back(counted(out_of_reach_, "face uses a vertex that is not finite or beyond 1e18 and is left out",
                               "faces use a vertex that is not finite or beyond 1e18 and are left out"));
  }
}

}  // namespace dini

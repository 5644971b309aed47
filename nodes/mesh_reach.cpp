#include "nodes/mesh_reach.h"

#include <algorithm>
#include <cmath>

#include "geometry/clip.h"
#include "geometry/validate.h"

namespace dini {

double least_change(const Mesh& mesh) {
  double largest = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Point p = mesh.positions[i];
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return relative_round_off * largest;
}

bool is_mesh_within_reach(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (!is_within_reach(mesh.positions[i])) return false;
  }
  return true;
}

}  // namespace dini

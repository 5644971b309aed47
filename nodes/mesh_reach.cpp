#include "nodes/mesh_reach.h"

#include "geometry/chunks.h"
#include "geometry/same_place.h"
#include "geometry/validate.h"

namespace dini {

double least_change(const Mesh& mesh, const Cancel& cancel) {
  CancelEvery looks(cancel);
  return relative_round_off * largest_coordinate_of(mesh.positions, looks);
}

bool is_mesh_within_reach(const Mesh& mesh, const Cancel& cancel) {
  const Column<Point>& positions = mesh.positions;
  return !first_where(cancel, positions.size(), [&](std::size_t i) { return !is_within_reach(positions[i]); });
}

}  // namespace dini

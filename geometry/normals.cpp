#include "geometry/normals.h"

#include "geometry/corner.h"
#include "geometry/weld.h"

namespace dini {

Column<Vector> smooth_normals(const Mesh& mesh, const Cancel& cancel) {
  const std::vector<std::uint32_t> labels = position_labels(mesh.positions, cancel);
  Zeroed<Vector> sums(mesh.positions.size());
  CancelEvery steps(cancel);
  for (const auto& triangle : mesh.triangles) {
    if (steps.stopped()) break;
    const std::array<Vector, 3> weighted = angle_weighted_normals(corners_of(mesh, triangle));
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Vector& sum = sums[labels[triangle[corner]]];
      sum = sum + weighted[corner];
    }
  }
  Column<Vector> normals(mesh.positions.size());
  for (std::size_t i = 0; i < normals.size() && !steps.stopped(); ++i) {
    const Vector sum = sums[labels[i]];
    // Triangles that cancel leave only round-off, whose direction means nothing.
    normals.set(i, squared_length(sum) > 1e-20 ? quick_unit(sum) : Vector{0, 0, 1});
  }
  return normals;
}

}  // namespace dini

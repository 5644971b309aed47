#include "geometry/normals.h"

#include "geometry/corner.h"
#include "geometry/in_order.h"
#include "geometry/weld.h"

namespace dini {

Column<Vector> smooth_normals(const Mesh& mesh, const Cancel& cancel) {
  const std::vector<std::uint32_t> labels = position_labels(mesh.positions, cancel);
  if (cancel.stopped()) return Column<Vector>(mesh.positions.size());
  Zeroed<Vector> sums(mesh.positions.size());
  const auto& triangles = *mesh.triangles;
  compute_in_order<std::array<Vector, 3>>(
      cancel, triangles.size(), [&](std::size_t i) { return angle_weighted_normals(corners_of(mesh, triangles[i])); },
      [&](std::size_t i, const std::array<Vector, 3>& weighted) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
          Vector& sum = sums[labels[triangles[i][corner]]];
          sum = sum + weighted[corner];
        }
      });
  Column<Vector> normals(mesh.positions.size());
  for_chunks(cancel, normals.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vector sum = sums[labels[i]];
      // Triangles that cancel leave only round-off, whose direction means nothing.
      normals.set(i, squared_length(sum) > 1e-20 ? quick_unit(sum) : Vector{0, 0, 1});
    }
  });
  return normals;
}

}  // namespace dini

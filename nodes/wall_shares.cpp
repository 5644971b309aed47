#include "nodes/wall_shares.h"

#include <algorithm>
#include <cmath>

#include "geometry/chunks.h"
#include "graph/literal.h"

namespace dini {

namespace {

/// The thickness at one place against the usual one, by the value of the field there.
double share_by_field(const WallThickness& in, double value) {
  const double way = value >= in.fade ? 1 : value > 0 ? value / in.fade : 0;
  return 1 + way * way * (3 - 2 * way) * (in.far_thickness / in.thickness - 1);
}

/// The samples beside a place in [0, 1] along an axis, and how far it is from the first to the second.
struct Between {
  std::size_t first, second;
  double way;
};

Between samples_beside(const Axis& axis, double place) {
  const double steps = static_cast<double>(axis.closed ? axis.size : axis.size - 1);
  const double at = std::clamp(place, 0.0, 1.0) * steps;
  const auto first = std::min(static_cast<std::size_t>(at), axis.size - 1);
  const std::size_t second = first + 1 < axis.size ? first + 1 : axis.closed ? 0 : first;
  return {first, second, std::min(at - static_cast<double>(first), 1.0)};
}

double factor_at(const Block<double, 2>& factors, const std::array<double, 2>& uv) {
  const Between u = samples_beside(factors.axis(0), uv[0]), v = samples_beside(factors.axis(1), uv[1]);
  return std::lerp(std::lerp(factors(u.first, v.first), factors(u.first, v.second), v.way),
                   std::lerp(factors(u.second, v.first), factors(u.second, v.second), v.way), u.way);
}

}  // namespace

Attempt<double> least_thickness(const WallThickness& in, const Cancel& cancel) {
  const double even = std::min(in.thickness, in.field ? in.far_thickness : in.thickness);
  if (!in.factors) return even;
  const Block<double, 2>& factors = *in.factors;
  double least = factors(0, 0);
  CancelEvery steps(cancel);
  for (std::size_t i = 0; i < factors.size(0) && !steps.stopped(); ++i) {
    for (std::size_t j = 0; j < factors.size(1); ++j) least = std::min(least, factors(i, j));
  }
  if (least > 0) return least * even;
  return Failure{"out-of-range", "a factor is " + to_text(least) + ", all have to be above 0", "factors"};
}

Attempt<std::vector<double>> shares_of_wall(const WallThickness& in, const WallSurface& surface, const Cancel& cancel) {
  if (!in.field && !in.factors) return std::vector<double>{};
  if (in.factors && surface.mesh.uvs.empty() && !surface.mesh.triangles.empty()) {
    return Failure{"degenerate",
                   "the mesh has no uv that would tell where each factor is; a surface, a tube, a sphere mesh or a "
                   "torus mesh has, or take a field",
                   "factors"};
  }
  const std::vector<Vector>& positions = surface.welded.positions;
  std::vector<std::size_t> vertices;
  if (in.factors) vertices = first_vertices(surface.welded, cancel);
  std::vector<double> shares(positions.size(), 1);
  if (cancel.stopped()) return shares;
  for_chunks(cancel, shares.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (in.field) shares[i] = share_by_field(in, value_at(**in.field, positions[i]));
      if (in.factors) shares[i] *= factor_at(*in.factors, (*surface.mesh.uvs)[vertices[i]]);
    }
  });
  return shares;
}

}  // namespace dini

#include "nodes/finish_surface.h"

#include <string>

namespace dini {

namespace {

/// Triangles of one surface while a value is being dragged; the final answer has no such bound.
constexpr std::size_t draft_triangles = 20'000;

}  // namespace

Attempt<SharedMesh> finish_surface(const Context& context, const PointGrid& grid, AtInfinity at_infinity,
                                   double clip_radius, const Axis& rows) {
  const std::size_t budget = context.quality() == Quality::draft ? draft_triangles : 0;
  SurfaceResult result = surface(grid, {at_infinity, clip_radius, budget}, context.cancel());
  if (result.first_clipped) {
    const std::string place = rows.name + " = " + std::to_string((*result.first_clipped)[0]);
    if (at_infinity == AtInfinity::fail) {
      return Failure{"at-infinity",
                     "the surface leaves the clip radius at " + place + "; choose clip, or a larger clip_radius",
                     "at_infinity"};
    }
    context.warn({"at-infinity", "the surface reaches infinity first at " + place + "; " +
                                     std::to_string(result.clipped_quads) + " quads were cut or left out"});
  }
  return std::make_shared<const Mesh>(std::move(result.mesh));
}

}  // namespace dini

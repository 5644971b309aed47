#include "nodes/finish_surface.h"

#include <string>

namespace dini {

Attempt<SharedMesh> finish_surface(const Context& context, const PointGrid& grid, AtInfinity at_infinity,
                                   double clip_radius, const Axis& rows) {
  SurfaceResult result = surface(grid, {at_infinity, clip_radius, context.triangle_budget()}, context.cancel());
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

#include "nodes/finish_surface.h"

#include <string>

namespace dini {

Attempt<SharedMesh> finish_surface(const Context& context, const PointGrid& grid, AtInfinity at_infinity,
                                   double clip_radius, const Axis* rows) {
  SurfaceResult result = surface(grid, {at_infinity, clip_radius, context.triangle_budget()}, context.cancel());
  if (!result.first_clipped) return std::make_shared<const Mesh>(std::move(result.mesh));
  const std::size_t row = (*result.first_clipped)[0];
  if (at_infinity == AtInfinity::fail) {
    const std::string along =
        rows == nullptr ? "row " + std::to_string(row) : "index " + std::to_string(row) + " of axis " + rows->name;
    return Failure{"at-infinity",
                   "the surface leaves the clip radius at " + along + "; choose clip, or a larger clip_radius",
                   "at_infinity"};
  }
  const std::string cut =
      std::to_string(result.clipped_quads) + " quads were cut or left out where the surface reaches infinity, first";
  if (rows == nullptr) {
    context.warn({"at-infinity", cut + " at row " + std::to_string(row)});
  } else {
    context.warn({"at-infinity", cut, "", ConsumedPlace{0, row}});
  }
  return std::make_shared<const Mesh>(std::move(result.mesh));
}

}  // namespace dini

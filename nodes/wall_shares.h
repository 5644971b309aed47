#pragma once

#include <optional>
#include <vector>

#include "geometry/scalar_field.h"
#include "geometry/thicken.h"
#include "graph/arguments.h"
#include "graph/context.h"
#include "graph/lift.h"

namespace dini {

/// What makes a wall uneven.
struct WallThickness {
  double thickness;                         ///< in meters, where nothing makes it another one
  std::optional<SharedField> field;         ///< a solid that has this thickness; away from it the other one
  double far_thickness;                     ///< beyond the fade
  double fade;                              ///< the distance within which one goes into the other
  std::optional<Block<double, 2>> factors;  ///< of the thickness, over the uv of the mesh
};

/// The least thickness that a wall may have at any place, in meters. A failure where a factor is not above 0. Stopped
/// early: that of some factors.
Attempt<double> least_thickness(const WallThickness& in, const Cancel& cancel);

/// Factors of the thickness for each distinct position of a surface; none where the wall is even. What is given as
/// `factors` is linear between its samples: the first axis runs along u and the second along v, closed ones all around.
/// A failure where the mesh has no uv to find them by. Stopped early: meaningless.
Attempt<std::vector<double>> shares_of_wall(const WallThickness& in, const WallSurface& surface, const Cancel& cancel);

}  // namespace dini

#pragma once

#include <vector>

#include "algebra/kernels.h"
#include "geometry/scalar_field.h"

namespace dini {

/// The solid under a warp by generators, each weighted by 1 / (d^power + softening): the field is pulled back, at each
/// place by the opposite of the rotor exp(strength * weighted sum) that the warp has there. Values are divided by the
/// conformal factor of that rotor; where the weights change over the size of the solid, that is not the whole stretch,
/// and distances are no more than nearly right. At a generator without softening the place stays.
SharedField warped_field(SharedField field, std::vector<kernels::WarpSource> sources, double strength, double power,
                         double softening);

}  // namespace dini

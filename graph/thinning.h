#pragma once

#include <set>
#include <string>

#include "graph/plan.h"

namespace dini {

/// Shares the triangle budget of a draft among the meshes that the `needed` nodes of a plan make, so that what they end
/// up as fits: all are thinned in proportion to their predicted size, and none when everything fits.
void share_triangles(Plan& plan, const std::set<std::string>& needed);

}  // namespace dini

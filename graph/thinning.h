#pragma once

#include <set>
#include <string>

#include "graph/plan.h"

namespace dini {

/// Shares the triangle budget of a draft among the meshes that the `needed` nodes of a plan make, each after its
/// predicted size, so that the large ones give most. Nothing is thinned when everything fits.
void share_triangles(Plan& plan, const std::set<std::string>& needed);

}  // namespace dini

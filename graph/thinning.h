#pragma once

#include <optional>
#include <set>
#include <string>

#include "graph/context.h"
#include "graph/plan.h"

namespace dini {

/// Shares the triangle budget of a draft among the meshes that the `needed` nodes of a plan make, so that what they end
/// up as fits: all are thinned in proportion to their predicted size, down to the fewest that they can be made of, and
/// none when everything fits.
void share_triangles(Plan& plan, const std::set<std::string>& needed);

/// What is said about a file of a draft that has more triangles than its budget.
std::optional<Warning> unkept_budget(const Plan& plan, std::size_t triangles);

}  // namespace dini

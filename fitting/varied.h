#pragma once

#include <string>
#include <vector>

#include "graph/problem.h"

namespace dini::fitting {

/// A parameter that may change, with its bounds and where it is at first.
struct Varied {
  std::string name;
  double lowest = 0, highest = 1;
  double start = 0;  ///< within the bounds
};

/// A setting of all varied parameters: 0 is the lowest and 1 the highest value of each.
using Place = std::vector<double>;

/// The parameters that `vary` lists, in the order of their names: numbers only, within their own bounds. `interface` is
/// that of the graph, `parameters` the given values. Problems name the parameter and what would be accepted.
Result<std::vector<Varied>> read_varied(const Json& vary, const Json& interface, const Json& parameters);

/// The same for derivatives: these parameters, or all that are numbers; bounds that are missing are infinite. Problems
/// stand at the member `by`.
Result<std::vector<Varied>> read_differentiated(const std::vector<std::string>& names, const Json& interface,
                                                const Json& parameters);

/// The values by parameter at a place.
Json setting_at(const std::vector<Varied>& varied, const Place& place);

/// Where the parameters are at first.
Place start_of(const std::vector<Varied>& varied);

}  // namespace dini::fitting

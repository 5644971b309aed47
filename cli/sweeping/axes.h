#pragma once

#include <string>
#include <vector>

#include "graph/problem.h"
#include "service/engine.h"

namespace dini::cli {

/// The values of each parameter of a sweep, by name, as the grid of `Variants`: `reach=0:2:9` of --grid is 9 numbers
/// from 0 to 2, both included; `rule=paper,exact` of --list is these values, each JSON if it parses and else text.
/// Commas inside of brackets, braces and quotes do not separate. Problems: `usage`, also for a parameter that is given
/// twice, and for none at all.
Result<Json> read_axes(const std::vector<std::string>& grids, const std::vector<std::string>& lists,
                       const Limits& limits);

/// A value as it stands in the name of a file: texts without quotes, and nothing that separates folders.
std::string name_of_value(const Json& value);

}  // namespace dini::cli

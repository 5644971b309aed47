#pragma once

// The query of an address is declared as the members of a body are: a name that is not known is a problem.

#include <map>
#include <string>
#include <vector>

#include "server/operation.h"
#include "server/request.h"

namespace dini::server {

/// The names of those that stand in a query, in their order.
std::vector<std::string> query_names(const std::vector<Parameter>& parameters);

/// The query of a request by name; a name that is none of these, or comes twice, is a problem.
Result<std::map<std::string, std::string>> read_query(const Request& request, const std::vector<std::string>& names);

}  // namespace dini::server

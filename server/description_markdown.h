#pragma once

#include <string>
#include <string_view>

#include "graph/problem.h"

namespace dini::server {

/// A page of Markdown with its generated parts written anew. A part stands between the lines
/// `<!-- generated: NAME -->` and `<!-- end -->`. Names: `routes`, `limits`, `statuses`, `headers`, `codes`, and
/// `members ID`, `parameters ID`, `answers ID` of an operation. The problem has code `usage`: a name that is none, or a
/// part without an end.
Result<std::string> with_generated_parts(std::string_view page);

}  // namespace dini::server

#pragma once

#include "server/application.h"
#include "server/operation.h"

namespace dini::server {

/// An answer with a whole file, cut to the one part that `Range` of a GET names (RFC 9110, 14). Several parts, other
/// units, and an `If-Range` that is not `tag` are answered with the whole file; a part beyond its end with 416.
Reply with_range(Reply whole, const Context& context, std::string_view tag);

Parameter range_header();

}  // namespace dini::server

#pragma once

#include "server/reply.h"
#include "server/request.h"

namespace dini::server {

/// Takes over how others name a request: `X-Request-Id`, when it is 1 to 64 of [A-Za-z0-9._-], and the trace and the
/// span of a valid `traceparent` (W3C Trace Context, level 1). What is neither is passed over, as that asks for.
void take_names(const Request& request, Exchange& exchange);

}  // namespace dini::server

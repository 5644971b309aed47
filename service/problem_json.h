#pragma once

#include "graph/problem.h"

namespace dini {

/// What a client sent, so what its pointers lead into: a request with the graph document as its member `graph`, or the
/// document alone.
enum class Sent { request, document };

/// A list of problems as JSON: [{"code", "detail", "node", "port", "pointer", "fix"}], absent members left out.
/// Pointers and fixes lead into what was sent; a fix of a request that was never written is left out.
Json to_json(const Problems& problems, Sent sent = Sent::request);

}  // namespace dini

#pragma once

#include "service/engine.h"

namespace dini {

/// What is asked of an engine, however it was spelled: by the hash of the graph, the parameters and all else that is
/// asked. Requests of equal identity have equal answers.
Digest identity_of(const EvaluateRequest& request);
Digest identity_of(const InspectRequest& request);

/// About how much memory a request holds, its graph included.
std::size_t memory_of(const EvaluateRequest& request);

}  // namespace dini

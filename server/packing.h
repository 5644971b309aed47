#pragma once

// Answers that are text are packed with gzip for clients that take it.

#include "server/reply.h"

namespace dini::server {

/// The answer, packed where it is worth it and its client takes it: JSON and other text of some size, whole. Its tag
/// stays: it names what is said, and no parts of such an answer are ever given.
Reply packed(Reply reply, const Exchange& exchange);

}  // namespace dini::server

#pragma once

#include "queue/connection.h"

// What Redis does in one piece; each stands in a file of its own in queue/scripts, whose head says what it takes and
// answers.

namespace dini::queue::scripts {

extern const Script submit;
extern const Script collect;
extern const Script redo;
extern const Script drop;
extern const Script take;
extern const Script finish;
extern const Script beat;
extern const Script leave;
extern const Script dead_retry;
extern const Script release;

}  // namespace dini::queue::scripts

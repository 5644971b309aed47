#pragma once

#include "graph/registry.h"

namespace dini {

/// The nodes that make solids of surfaces, and the one that judges them; nodes/all.cpp adds them.
void add_thicken(Registry& registry);
void add_offset(Registry& registry);
void add_cap(Registry& registry);
void add_printability(Registry& registry);

}  // namespace dini

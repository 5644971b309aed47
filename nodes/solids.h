#pragma once

#include "graph/registry.h"

namespace dini {

void add_thicken(Registry& registry);
void add_offset(Registry& registry);
void add_cap(Registry& registry);
void add_printability(Registry& registry);

}  // namespace dini

#pragma once

#include "graph/registry.h"

namespace dini {

void add_mirror(Registry& registry);
void add_array(Registry& registry);
void add_array_along(Registry& registry);
void add_helix(Registry& registry);
void add_curve_through(Registry& registry);
void add_noise(Registry& registry);
void add_smooth(Registry& registry);
void add_slice(Registry& registry);

}  // namespace dini

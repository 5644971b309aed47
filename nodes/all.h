#pragma once

#include "graph/registry.h"

namespace dini {

/// Adds every node type of the catalogue, one line per family in nodes/all.cpp.
void add_all_nodes(Registry& registry);

void add_numbers(Registry& registry);
void add_random(Registry& registry);
void add_elements(Registry& registry);
void add_rounds(Registry& registry);
void add_relations(Registry& registry);
void add_generators(Registry& registry);
void add_curvature(Registry& registry);
void add_transforms(Registry& registry);
void add_operators(Registry& registry);
void add_reflect(Registry& registry);
void add_array(Registry& registry);
void add_array_along(Registry& registry);
void add_between(Registry& registry);
void add_flow(Registry& registry);
void add_evolve(Registry& registry);
void add_fields(Registry& registry);
void add_implicit(Registry& registry);
void add_implicit_surface(Registry& registry);
void add_curves(Registry& registry);
void add_noise(Registry& registry);
void add_sampling(Registry& registry);
void add_helix(Registry& registry);
void add_curve_through(Registry& registry);
void add_surfaces(Registry& registry);
void add_meshes(Registry& registry);
void add_mesh_tools(Registry& registry);
void add_mirror(Registry& registry);
void add_smooth(Registry& registry);
void add_slice(Registry& registry);
void add_thicken(Registry& registry);
void add_offset(Registry& registry);
void add_cap(Registry& registry);
void add_import(Registry& registry);
void add_answers(Registry& registry);
void add_printability(Registry& registry);
void add_export(Registry& registry);

/// The families in the order a catalogue shows them, with their titles: [{"name", "title"}].
Json family_titles();

}  // namespace dini

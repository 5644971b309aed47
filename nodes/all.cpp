#include "nodes/all.h"

namespace dini {

void add_all_nodes(Registry& registry) {
  add_numbers(registry);
  add_random(registry);
  add_elements(registry);
  add_rounds(registry);
  add_relations(registry);
  add_generators(registry);
  add_curvature(registry);
  add_transforms(registry);
  add_operators(registry);
  add_reflect(registry);
  add_mirror(registry);
  add_array(registry);
  add_array_along(registry);
  add_between(registry);
  add_flow(registry);
  add_evolve(registry);
  add_fields(registry);
  add_implicit(registry);
  add_implicit_surface(registry);
  add_curves(registry);
  add_noise(registry);
  add_sampling(registry);
  add_helix(registry);
  add_curve_through(registry);
  add_surfaces(registry);
  add_meshes(registry);
  add_mesh_tools(registry);
  add_smooth(registry);
  add_slice(registry);
  add_thicken(registry);
  add_offset(registry);
  add_cap(registry);
  add_import(registry);
  add_answers(registry);
  add_printability(registry);
  add_export(registry);
}

Json family_titles() {
  return {{{"name", "numbers"}, {"title", "Numbers"}},       {{"name", "elements"}, {"title", "Elements"}},
          {{"name", "generators"}, {"title", "Generators"}}, {{"name", "transforms"}, {"title", "Transforms"}},
          {{"name", "fields"}, {"title", "Fields"}},         {{"name", "implicit"}, {"title", "Implicit solids"}},
          {{"name", "sampling"}, {"title", "Sampling"}},     {{"name", "surfaces"}, {"title", "Surfaces"}},
          {{"name", "meshes"}, {"title", "Meshes"}},         {{"name", "answers"}, {"title", "Answers"}}};
}

}  // namespace dini

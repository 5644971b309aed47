#include "geometry/solid_facts.h"

#include "geometry/contacts.h"

namespace dini {

SolidFacts solid_facts(const Mesh& mesh, std::size_t most_contacts, const Cancel& cancel) {
  const WeldedMesh surface = welded(mesh, cancel);
  return {soundness_of(surface, cancel), contacts_of(surface, most_contacts, cancel).pairs,
          least_thickness(surface, cancel), mass_properties(surface, cancel)};
}

}  // namespace dini

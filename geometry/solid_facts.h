#pragma once

#include "geometry/solid.h"

namespace dini {

/// All that is told of a mesh to judge whether it can be made: see geometry/solid.h and geometry/contacts.h.
struct SolidFacts {
  Soundness sound;
  std::size_t contacts = 0;  ///< pairs of triangles that meet, up to what was asked for
  double least_thickness = 0;
  MassProperties mass;
};

/// Counts `most_contacts` pairs of triangles that meet, no more. n log n. Stopped early: meaningless.
SolidFacts solid_facts(const Mesh& mesh, std::size_t most_contacts, const Cancel& cancel);

}  // namespace dini

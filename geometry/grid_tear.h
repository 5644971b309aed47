#pragma once

// Tells a quad of a grid through which the surface ran to infinity and back from an ordinary one.
//
// A sampled surface seldom hits infinity in a sample; it goes through it between samples. Joining those samples draws a
// slab across the whole scene. Seen in projective space, the true piece is the outside of the quad that the four
// corners span: so that quad is turned inside out against the quads before and after it, and it is longer than both
// together.

#include "algebra/vector.h"

namespace dini {

/// The two facts about a quad that the test needs.
struct QuadShape {
  Vector area;         ///< along the area vector; only its direction counts
  Vector step;         ///< mean of the two sides along the tested axis
  bool known = false;  ///< false beyond borders and next to samples that are not finite
};

/// Whether `quad`, with its neighbors along the tested axis, holds infinity. Steps shorter than `least_step` never do.
bool holds_infinity(const QuadShape& before, const QuadShape& quad, const QuadShape& after, double least_step);

}  // namespace dini

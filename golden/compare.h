#pragma once

#include "golden/model_facts.h"

namespace dini {

/// How a model compares with a golden one.
struct Comparison {
  enum class Verdict {
    same,     ///< the same bytes
    within,   ///< other bytes of the same shape
    changed,  ///< another shape, or other colors
  };

  Verdict verdict = Verdict::same;
  double deviation = 0;                       ///< meters: the farthest that a kept point is from the model
  double accepted = 0;                        ///< meters
  std::vector<std::string> differences = {};  ///< sentences that say what, where, and by how much
};

/// `tolerance` is a share of the largest extent of the golden model. What both files round positions by is accepted
/// besides, so an engine that rounds otherwise gives the same shape. Compared are numbers of triangles, segments and
/// points, the topology, bounds, area and volume; the distance of each kept point from the model with color and normal
/// there; and whether the model has a part that is far from all kept points.
Comparison compare(const ModelFacts& golden, const Model& model, double tolerance);

}  // namespace dini

#pragma once

#include "graph/check.h"
#include "graph/evaluate.h"
#include "service/parts.h"
#include "service/prepared.h"
#include "service/problem_json.h"

namespace dini {

/// What the engine over the catalogue computes.
class ComputedGraph final : public Computed {
 public:
  Evaluation evaluation;
  std::shared_ptr<const ToldParts> parts;  ///< null unless they are to be told
};

/// The report of an evaluation: times, what was cached, types and axes, the file, checks and warnings; see
/// docs/http.md.
Json evaluation_report(const PreparedGraph& prepared, const ComputedGraph& computed, Sent sent, Extent extent);

/// The answer of a validation: whether the graph is well, its problems, its wires and its cost.
Json validation_report(const CheckReport& report, const Problems& problems, Sent sent);

}  // namespace dini

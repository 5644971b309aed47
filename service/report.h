#pragma once

#include "graph/check.h"
#include "graph/evaluate.h"
#include "service/prepared.h"
#include "service/problem_json.h"

namespace dini {

/// What every file says about itself: engine, content hash of the graph, and the parameters that shaped it.
Json file_extras(const Plan& plan, std::size_t output);

/// A finished file of a model, and what was told when it was made.
struct ModelFile {
  SharedFile file;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  double position_error = 0;
};

/// What the engine over the catalogue computes.
class ComputedGraph final : public Computed {
 public:
  Evaluation evaluation;
  std::shared_ptr<const ModelFile> model_file;  ///< null without an output
};

/// The report of an evaluation: times, what was cached, types and axes, the file, checks and warnings; see
/// docs/http.md.
Json evaluation_report(const PreparedGraph& prepared, const ComputedGraph& computed, Sent sent);

/// The answer of a validation: whether the graph is well, its problems, its wires and its cost.
Json validation_report(const CheckReport& report, const Problems& problems, Sent sent);

}  // namespace dini

#pragma once

// Every request that a client can make with a JSON body: what is asked of the engine, and until when.

#include <optional>
#include <string>
#include <vector>

#include "service/engine.h"
#include "service/requests/description.h"
#include "service/variants.h"

namespace dini {

/// The body of POST /v1/evaluate.
struct EvaluateBody : EvaluateRequest {
  std::optional<std::int64_t> deadline_milliseconds = {};
};

/// The body of POST /v1/inspect.
struct InspectBody : InspectRequest {
  std::optional<std::int64_t> deadline_milliseconds = {};
};

/// The body of POST /v1/sweeps. The parameters are those that all variants share.
struct SweepBody : EvaluateRequest, SweepAxes {
  std::optional<std::vector<std::string>> outputs = {};  ///< instead of `output`: several
  bool models = true;
  std::int64_t first = 0;  ///< the variant to begin with
  std::optional<std::int64_t> deadline_milliseconds = {};
};

/// The body of POST /v1/validate.
struct ValidateBody {
  SharedGraph graph = {};
  Json parameters = Json::object();
  std::optional<std::int64_t> deadline_milliseconds = {};
};

const RequestDescription& evaluate_description();
const RequestDescription& inspect_description();
const RequestDescription& sweep_description();
const RequestDescription& validate_description();

// What such a body says. Its graph is read by the engine.
Result<EvaluateBody> read_evaluate_body(Json body, const Engine& engine);
Result<InspectBody> read_inspect_body(Json body, const Engine& engine);
Result<SweepBody> read_sweep_body(Json body, const Engine& engine);
Result<ValidateBody> read_validate_body(Json body, const Engine& engine);

/// What is wrong with the outputs that a sweep lists: there is none, one stands twice, or the graph has not that one.
/// Pointers begin with `/outputs`.
Problems faults_in_outputs(const std::vector<std::string>& outputs, const Graph& graph, const Engine& engine);

}  // namespace dini

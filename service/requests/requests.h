#pragma once

// Every request that a client can make with a JSON body: what is asked of the engine, and until when.

#include "service/engine.h"
#include "service/requests/description.h"

namespace dini {

/// The body of POST /v1/evaluate.
struct EvaluateBody : EvaluateRequest {
  std::optional<std::int64_t> deadline_milliseconds = {};
};

/// The body of POST /v1/inspect.
struct InspectBody : InspectRequest {
  std::optional<std::int64_t> deadline_milliseconds = {};
};

/// The body of POST /v1/validate.
struct ValidateBody {
  Json graph = {};
  Json parameters = Json::object();
  std::optional<std::int64_t> deadline_milliseconds = {};
};

const RequestDescription& evaluate_description();
const RequestDescription& inspect_description();
const RequestDescription& validate_description();

Result<EvaluateBody> read_evaluate_body(Json body);
Result<InspectBody> read_inspect_body(Json body);
Result<ValidateBody> read_validate_body(Json body);

}  // namespace dini

#pragma once

#include "graph/problem.h"

namespace dini {

/// The schemas of everything that comes back as JSON from the engine, by name: Validation, Inspection, Report,
/// AssetSummary, Catalogue, Graph, ProblemEntry, and what these are made of. They refer to each other as components of
/// an OpenAPI document.
const Json& result_schemas();

/// Those of graphs that are kept.
Json stored_graph_schemas();

/// That of what an evaluation would do.
Json explain_schemas();

/// Those of what a fit finds, and of derivatives.
Json fit_schemas();

/// Those of jobs.
Json job_schemas();

}  // namespace dini

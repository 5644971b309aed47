#pragma once

// Previews: chosen nodes of a graph drawn into a file of their own, beside the model or instead of it.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "geometry/cancel.h"
#include "gltf/encode_options.h"
#include "graph/evaluate.h"
#include "graph/limits.h"
#include "graph/registry.h"
#include "service/prepared.h"

namespace dini {

/// Which outputs of which nodes are to be drawn, before anything is planned.
using PreviewNames = std::map<std::string, std::set<std::size_t>>;

/// Reads "node" (all its outputs) and "node.output". Repeats do not count. Problems: `unknown-node` and `unknown-port`
/// with the pointer of the entry, `limit-exceeded` for too many of them.
Result<PreviewNames> read_previews(const Registry& registry, const Document& document,
                                   const std::vector<std::string>& asked, const Limits& limits);

/// The same nodes in a plan that has them; what drawing them needs is added to its cost. Their meshes together keep
/// within the limit of one result, and everything within those of the request.
Result<std::vector<Preview>> plan_previews(Plan& plan, const PreviewNames& names, const Limits& limits);

/// Everything that the bytes of the drawn previews depend on, before they are computed.
Digest preview_digest(const Plan& plan, const std::vector<Preview>& previews, const Limits& limits);

/// The file, from an evaluation of all previewed nodes: docs/http.md says what is in it. `options` is how it
/// is written.
Result<std::string> draw_previews(const Plan& plan, const Evaluation& evaluation, const std::vector<Preview>& previews,
                                  const EncodeOptions& options, const Limits& limits, const Cancel& cancel);

}  // namespace dini

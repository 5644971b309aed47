#pragma once

#include <memory>

#include "draco/topology_cache.h"
#include "graph/asset_file.h"
#include "graph/registry.h"
#include "service/engine.h"
#include "service/prepared.h"

namespace dini {

/// What requests are checked against.
struct Environment {
  const Registry& registry;
  const Limits& limits;
  std::span<const FileFormat> formats;
  TopologyCache& topologies;
  AssetFinder find_asset;
};

/// Reads and checks an evaluation: its output, its previews, and what those depend on.
Result<std::shared_ptr<const PreparedGraph>> prepare_evaluation(const Environment& environment,
                                                                const EvaluateRequest& request, const Cancel& cancel);

/// The nodes that stand behind those that keep a request from being prepared; empty when it is the request itself.
std::vector<std::string> blocked_nodes(const Environment& environment, const EvaluateRequest& request,
                                       const Cancel& cancel);

/// The plan of everything that one node depends on. The node is in it unless there are problems.
Result<Plan> prepare_inspection(const Environment& environment, const InspectRequest& request, const Cancel& cancel);

}  // namespace dini

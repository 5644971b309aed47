#pragma once

// A plan: a checked graph with everything resolved that can be known before anything is computed.

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "graph/digest.h"
#include "graph/document.h"
#include "graph/node_type.h"

namespace dini {

/// What is known about a wire before evaluation. Vertices are those of all meshes on it.
struct WireShape {
  WireType type = WireType::number;
  Axes axes;
  std::size_t vertices = 0;       ///< about so many: costs and limits go by them
  std::size_t most_vertices = 0;  ///< never more than these
};

/// Output `output` of the planned node `node`.
struct Source {
  std::size_t node = 0;
  std::size_t output = 0;
};

/// One thing that reaches an input: a wire or a literal.
struct PlannedItem {
  std::variant<Source, Argument> from;
  WireShape shape;
  Origin origin = {};  ///< of a wire, for nodes that name parts
};

/// What reaches one port; no items when the port is left out. `list_axis` joins the items of a list.
struct PlannedInput {
  std::vector<PlannedItem> items;
  std::optional<Axis> list_axis;
  WireShape shape;
  std::set<std::string> parameters = {};  ///< graph parameters that reach this port directly
};

struct PlannedNode {
  std::string id;
  const NodeType* type = nullptr;
  const Overload* overload = nullptr;  ///< null for a bypassed node
  std::optional<PlannedItem> bypass;   ///< what a bypassed node passes on
  std::vector<PlannedInput> inputs;
  Literals literals;
  Axes lifted;
  Axes consumed;
  std::vector<Axes> made;
  std::vector<WireShape> outputs;
  std::size_t triangle_budget = 0;              ///< for each mesh that the node makes; 0 is no limit
  std::shared_ptr<const WantedFile> file = {};  ///< how the file is wanted that the node writes
  Digest fingerprint{};
  bool doubtful = false;  ///< broken, or behind a broken node: its wires are known, but it cannot run
};

/// Predicted totals of a plan.
struct Cost {
  std::size_t samples = 0;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t bytes = 0;  ///< a bound of the memory
  std::size_t work = 0;   ///< in units of about a nanosecond of one processor
};

struct Plan {
  std::vector<PlannedNode> nodes;  ///< every node after the nodes it needs
  std::map<std::string, std::size_t> index;
  ParameterValues parameters;
  Detail detail;
  Cost cost;
};

/// The node whose outputs stand at a planned node: itself unless it is bypassed.
std::size_t standing_at(const Plan& plan, std::size_t node);

/// The graph parameters that can change the outputs of a node.
std::set<std::string> parameters_behind(const Plan& plan, std::size_t node);

}  // namespace dini

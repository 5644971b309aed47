#pragma once

// The engine: one request answered, whoever asks. The server and the command line are two thin faces over this class,
// so a graph gives the same bytes and the same problems through both.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/cancel.h"
#include "graph/context.h"
#include "graph/json_reader.h"
#include "graph/limits.h"
#include "graph/problem.h"

namespace dini {

/// What to evaluate: a graph document, values for its parameters by name, the node to export, and nodes to draw.
struct EvaluateRequest {
  Json graph;
  Json parameters = Json::object();
  /// Empty: nothing when something is previewed, else the only export node of the graph; several are a problem that
  /// lists them.
  std::string output;
  Quality quality = Quality::final;
  /// About how many triangles a draft has, 100 to 10 million; refused for a final answer.
  std::optional<std::int64_t> triangle_budget = {};
  /// Nodes ("node") and single outputs ("node.output") to draw into a file of their own; their order does not count.
  std::vector<std::string> preview = {};
};

/// What to look at: one output of one node. An empty `output` means the node's only or first output.
struct InspectRequest {
  Json graph;
  Json parameters = Json::object();
  std::string node;
  std::string output;
  bool full = false;  ///< meshes with positions and indices
};

/// What is known of a mesh file once it has been read.
struct AssetSummary {
  std::string sha256;  ///< 64 hexadecimal digits: what graphs write to mean this file
  std::size_t bytes = 0;
  std::string format;  ///< obj, ply or glb
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::vector<std::string> warnings = {};  ///< sentences about what of the file the mesh has not
};

/// A checked request: everything that is known before anything is computed.
class Prepared;

/// A finished evaluation.
struct Evaluated {
  std::shared_ptr<const std::string> glb;      ///< the finished file, extras included; null without an output
  std::shared_ptr<const std::string> preview;  ///< the previewed nodes as a file; null when none were asked for
  std::map<std::string, double> milliseconds;  ///< by step: prepare, evaluate, encode, preview
  std::function<Json()> report;                ///< writes times, sizes, checks, warnings per node; see docs/http.md
};

class Engine {
 public:
  explicit Engine(Limits limits = {});
  ~Engine();

  const Limits& limits() const;

  /// The cards of every node type and wire type: the body of `GET /v1/nodes`.
  const Json& catalogue() const;

  /// Reads a mesh file (OBJ, PLY or GLB, told by its content) and keeps the mesh for graphs that name it by its hash.
  /// With a `name` it is kept for ever and graphs may use the name too (letters, digits, `_`, `-`, `.`); without one it
  /// goes when `asset_store_bytes` are full and others were used later. Problems: `invalid-asset` for what is no such
  /// file, `limit-exceeded`, `usage` for a name that cannot be one, and those of `evaluate` when `cancel` stops it.
  Result<AssetSummary> add_asset(std::string_view bytes, const std::string& name = "", const Cancel& cancel = {}) const;

  /// Every static problem at once, inferred types and axes per wire, predicted sizes. Never evaluates, never fails.
  /// {"valid": bool, "errors": [...], "wires": {...}, "cost": {...}}
  Json validate(const Json& graph, const Json& parameters) const;

  /// Reads and checks what the output and the previews depend on; nothing is computed. Problems of other nodes never
  /// stand in the way: the report lists them as warnings, and a check that cannot run as not passed. The entity tag
  /// depends on everything that can influence the bytes.
  Result<std::shared_ptr<const Prepared>> prepare(const EvaluateRequest& request) const;
  /// Of a request that cannot be prepared: the nodes that are well in themselves but stand behind the ones to blame.
  std::vector<std::string> blocked(const EvaluateRequest& request) const;

  static const std::string& entity_tag(const Prepared& prepared);

  /// Evaluates and encodes. Identical concurrent calls compute once. Problems with the codes `deadline`, `superseded`
  /// and `client-gone` mean that `cancel` stopped the work.
  Result<Evaluated> evaluate(const Prepared& prepared, const Cancel& cancel) const;

  /// The value on any wire, in full double precision.
  Result<Json> inspect(const InspectRequest& request, const Cancel& cancel) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A problem list as JSON: [{"code", "detail", "node", "port", "pointer", "fix"}], absent members left out.
Json to_json(const Problems& problems);

}  // namespace dini

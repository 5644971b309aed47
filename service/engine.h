#pragma once

// The engine: one request answered, whoever asks. The server and the command line are thin faces over it, so a graph
// gives the same bytes and the same problems through both.

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/cancel.h"
#include "graph/asset_keeper.h"
#include "graph/context.h"
#include "graph/file.h"
#include "graph/job.h"
#include "graph/json_reader.h"
#include "graph/limits.h"
#include "graph/problem.h"
#include "service/graph.h"
#include "service/problem_json.h"

namespace dini {

/// What to evaluate: a graph, values for its parameters by name, the node to export, and nodes to draw.
struct EvaluateRequest {
  static constexpr std::int64_t least_triangle_budget = 100;
  static constexpr std::int64_t most_triangle_budget = 10'000'000;

  SharedGraph graph;
  Json parameters = Json::object();
  /// Empty: nothing when something is previewed, else the only export node of the graph; several are a problem that
  /// lists them.
  std::string output = {};
  Quality quality = Quality::final;
  /// About how many triangles a draft has, within the two above; refused for a final answer.
  std::optional<std::int64_t> triangle_budget = {};
  /// Nodes ("node") and single outputs ("node.output") to draw into a file of their own; their order does not count.
  std::vector<std::string> preview = {};
  /// Outputs whose values the report tells, as "node" or "node.output".
  std::vector<std::string> measures = {};
  /// Whether the report tells what each part of the model is; refused without an output.
  bool parts = false;
  /// No model of an output is wanted, only measures and checks.
  bool without_output = false;
  /// The name of the format that the output is written in; empty is the first. Previews are GLB always.
  std::string format = {};
  /// Whether meshes of the output may be compressed with Draco; false counts more than what the export node says.
  bool draco = true;
  /// Whether the file carries the document, in `document` of what it says about itself.
  bool embed_graph = false;
  /// What that document has besides the graph: see `notes_of`.
  Json notes = Json::object();
};

/// What to look at: one output of one node. An empty `output` means the node's only or first output.
struct InspectRequest {
  SharedGraph graph;
  Json parameters = Json::object();
  std::string node = {};
  std::string output = {};
  bool full = false;  ///< meshes with positions and indices
};

/// What is known of a mesh file once it has been read.
struct AssetSummary {
  std::string sha256;  ///< 64 hexadecimal digits: what graphs write to mean this file
  std::size_t bytes = 0;
  std::string format;  ///< obj, ply, stl or glb
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::vector<std::string> warnings = {};  ///< sentences about what of the file the mesh has not
};

/// A checked request: everything that is known before anything is computed. Each engine has its own kind.
class Prepared {
 public:
  virtual ~Prepared() = default;

  /// What the files depend on. Requests of equal content have equal files, whatever their nodes are called, and what
  /// was computed for one answers the other.
  Digest content{};
  std::string model_tag;   ///< strong entity tag of the files, with its quotes
  std::string report_tag;  ///< entity tag of everything that a report tells besides times, with its quotes
  std::string output;      ///< the export node; empty without one
  std::size_t bytes = 0;   ///< predicted memory of the evaluation
  std::size_t work = std::numeric_limits<std::size_t>::max();  ///< predicted nanoseconds of one processor
  std::size_t held = 0;                                        ///< memory that this itself holds, about
};

/// A finished computation, shared by all whose requests have its content. Each engine has its own kind.
class Computed {
 public:
  virtual ~Computed() = default;

  SharedFile model;                            ///< null without an output
  SharedFile preview;                          ///< null when nothing is previewed
  std::map<std::string, double> milliseconds;  ///< by step: evaluate, encode, preview; 0 for what was known
};

using SharedPrepared = std::shared_ptr<const Prepared>;
using SharedComputed = std::shared_ptr<const Computed>;

class ValueSource;

/// How much a report tells: the files, measures, checks and warnings, or also times, sizes and nodes.
enum class Extent { outcome, full };

class Engine {
 public:
  virtual ~Engine() = default;

  virtual const Limits& limits() const = 0;

  /// The formats that outputs are written in, the usual one first.
  virtual std::span<const FileFormat> formats() const = 0;

  /// The cards of every node type, wire type and format: the body of `GET /v1/nodes`.
  virtual const Json& catalogue() const = 0;

  /// Reads a mesh file (OBJ, PLY, STL or GLB, told by its content) and keeps the mesh for graphs that name it by its
  /// hash. With a `name` it is kept for ever and graphs may use the name too (letters, digits, `_`, `-`, `.`); without
  /// one it goes when `asset_store_bytes` are full and others were used later. Problems: `invalid-asset` for what is no
  /// such file, `limit-exceeded`, `usage` for a name that cannot be one, those of the keeper, and those of `compute`
  /// when `cancel` stops it.
  virtual Result<AssetSummary> add_asset(std::string_view bytes, const std::string& name,
                                         const Cancel& cancel) const = 0;

  /// A mesh file that was added, by the 64 hexadecimal digits of its hash; null when it is not here.
  virtual SharedBytes asset(std::string_view sha256) const = 0;

  /// From now on mesh files without a name are kept there, and looked for; null: in memory only.
  virtual void keep_assets_in(std::shared_ptr<AssetKeeper> keeper) const = 0;

  /// Reads a document for whatever is asked of it. A graph that was read before is handed out again while there is room
  /// for it. What is no graph says so when something is asked of it.
  virtual SharedGraph read(const Json& document) const = 0;

  /// What a graph looks like from outside: see service/interface.h. Problems: those of a document that cannot be read.
  virtual Result<Json> interface(const Graph& graph) const = 0;

  /// Every static problem at once, inferred types and axes per wire, predicted sizes. Never evaluates; fails only when
  /// `cancel` stops it. {"valid": bool, "errors": [...], "wires": {...}, "cost": {...}}
  virtual Result<Json> validate(const Graph& graph, const Json& parameters, const Cancel& cancel,
                                Sent sent = Sent::request) const = 0;

  /// Reads and checks what the output and the previews depend on; nothing is computed. Problems of other nodes never
  /// stand in the way: the report lists them as warnings. But a check that cannot run fails the request
  /// (`check-failed`), as one that does not hold would.
  virtual Result<SharedPrepared> prepare(const EvaluateRequest& request, const Cancel& cancel) const = 0;
  /// Of a request that cannot be prepared: the nodes that are well in themselves but stand behind the ones to blame.
  virtual std::vector<std::string> blocked(const EvaluateRequest& request, const Cancel& cancel) const = 0;

  /// Which nodes `compute` would run and why, with predicted sizes and times: the schema `Explanation`.
  virtual Json explain(const Prepared& prepared) const = 0;

  /// The answer, if nothing has to be computed for it; else null.
  virtual SharedComputed find(const Prepared& prepared) const = 0;

  /// Evaluates and encodes. Problems with the codes of `stopped_problem` mean that the job was stopped.
  virtual Result<SharedComputed> compute(const Prepared& prepared, const Job& job) const = 0;

  /// Whether all that comes of it is one file and what was said on the way, which `kept_form` holds.
  virtual bool is_shareable(const Prepared&) const { return false; }
  /// What was computed for a shareable request, as bytes for engines of the same version.
  virtual std::string kept_form(const Prepared&, const Computed&) const { return {}; }
  /// What `kept_form` told of a request of equal content, from now on known as if it had been computed here; null for
  /// other bytes.
  virtual SharedComputed restore(const Prepared&, std::string_view) const { return nullptr; }

  /// Times, sizes, checks and warnings per node: see docs/http.md. `computed` is for the same content, and was not
  /// found without what a report needs.
  virtual Json report(const Prepared& prepared, const Computed& computed, Sent sent, Extent extent) const = 0;
  Json report(const Prepared& prepared, const Computed& computed, Sent sent = Sent::request) const {
    return report(prepared, computed, sent, Extent::full);
  }

  /// What is kept of what was computed.
  struct CacheState {
    std::size_t bytes = 0;
    std::size_t entries = 0;
    std::size_t evictions = 0;  ///< how many results had to make room so far
  };
  virtual CacheState cache_state() const = 0;

  /// How often nodes of a type ran, and for how long in all, since the engine began.
  struct NodeTime {
    std::string type;
    std::size_t runs = 0;
    double seconds = 0;
  };
  virtual std::vector<NodeTime> node_times() const { return {}; }

  /// Lets go of everything that could be computed again, for when memory has run out.
  virtual void forget() const = 0;

  /// The value on any wire, in full double precision, as JSON text.
  virtual Result<SharedBytes> inspect(const InspectRequest& request, const Job& job) const = 0;

  /// Values for those who compute with them (service/value_source.h); null for an engine that has none.
  virtual const ValueSource* value_source() const { return nullptr; }
};

/// Every format that is written, the usual one first.
std::span<const FileFormat> usual_formats();

/// The engine over the whole catalogue of nodes, writing all formats.
std::unique_ptr<Engine> make_engine(const Limits& limits = {});

/// The same, writing these formats.
std::unique_ptr<Engine> make_engine(const Limits& limits, std::vector<FileFormat> formats);

/// JSON as text; bytes that are not UTF-8 are replaced.
std::string dump(const Json& json);

}  // namespace dini

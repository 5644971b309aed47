#pragma once

#include <span>
#include <string>
#include <vector>

#include "graph/value.h"
#include "service/engine.h"

namespace dini {

/// Which outputs of a graph are wanted as values.
struct ValuesRequest {
  SharedGraph graph = {};
  Json parameters = Json::object();      ///< those that all settings share
  std::vector<std::string> places = {};  ///< "node" or "node.output"
};

/// What a setting comes to: a value for each place, or why there is none.
using SettingValues = Result<std::vector<Value>>;

/// The values of outputs for those who compute with them, for many settings at once.
class ValueSource {
 public:
  virtual ~ValueSource() = default;

  /// Evaluates the settings (values by parameter) as one family: what several have in common is computed once, and
  /// everything else side by side. A setting that fails stops no other. No file is made; checks of the graph count.
  /// Settings are taken together as far as they fit into the limit of memory. The only problem of the whole is that of
  /// `stopped_problem`.
  virtual Result<std::vector<SettingValues>> values(const ValuesRequest& request, std::span<const Json> settings,
                                                    const Cancel& cancel) const = 0;

  /// The outputs that the only export node of a graph writes, as "node.output". Problems: those of a document that
  /// cannot be read, and `unknown-output` where there is not one such node.
  virtual Result<std::vector<std::string>> exported_places(const Graph& graph) const = 0;

  /// The mesh of a file that was added, by hash or name. The problem is `unknown-asset`.
  virtual Result<SharedAssetFile> mesh_file(const std::string& name, const Cancel& cancel) const = 0;
};

}  // namespace dini

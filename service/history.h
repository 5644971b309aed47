#pragma once

#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "graph/digest.h"
#include "graph/evaluate.h"
#include "graph/plan.h"
#include "service/engine.h"

namespace dini {

/// What an engine remembers of its evaluations besides their results, so that it can say why something has to be
/// computed and how long that takes. Bounded; any thread.
class History {
 public:
  /// Notes a finished evaluation of the graph with that hash.
  void note(const Digest& graph, const Plan& plan, const Evaluation& evaluation);

  /// Lets go of all but the speeds.
  void clear();

  /// Whether a node with that fingerprint was computed, as far as is remembered.
  bool was_computed(const Digest& fingerprint) const;

  /// The parameters of the last evaluation of a graph; nothing when none is remembered.
  std::optional<ParameterValues> last_parameters(const Digest& graph) const;

  /// What ran so far, by types of nodes.
  std::vector<Engine::NodeTime> node_times() const;

  /// Measured milliseconds for a unit of predicted work of a node type, or of all types while that one has not run.
  double milliseconds_per_unit(const std::string& type) const;

 private:
  struct Speed {
    double milliseconds = 0;
    double work = 0;
  };

  static constexpr std::size_t places = 16'384;

  static std::size_t place_of(const Digest& fingerprint);

  mutable std::mutex mutex_;
  /// Each at its place, where a later one may take it: what is forgotten so is called new.
  std::vector<Digest> computed_ = std::vector<Digest>(places);
  std::map<Digest, ParameterValues> parameters_;
  std::deque<Digest> parameters_order_;
  std::map<std::string, Speed> speeds_;
  std::map<std::string, Engine::NodeTime> times_;
  Speed all_;
};

}  // namespace dini

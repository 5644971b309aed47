#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "service/engine.h"
#include "service/requests/description.h"

namespace dini {

/// What a fit is asked: which parameters may change, and what is to come of it. At least one of `targets`,
/// `target_mesh` and `minimize` is given.
struct FitRequest {
  static constexpr std::int64_t most_starts = 100;
  static constexpr std::int64_t most_evaluations = 1'000'000;

  SharedGraph graph = {};
  Json parameters = Json::object();        ///< where the first start is
  Json vary = Json::object();              ///< by parameter: [lowest, highest], or [] for its own bounds
  Json targets = Json::object();           ///< by place: the number that is wanted, or a list of all its numbers
  std::string target_mesh = {};            ///< a mesh file that was added, by hash or name
  std::string mesh = {};                   ///< the place that is to be like it; empty: what the export node writes
  std::vector<std::string> minimize = {};  ///< places of numbers
  std::int64_t starts = 4;
  std::int64_t evaluations = 5'000;  ///< of the graph, in all
};

/// The body of POST /v1/fit.
struct FitBody : FitRequest {
  std::optional<std::int64_t> deadline_milliseconds = {};
};

/// What of a graph is differentiated by which of its parameters.
struct GradientRequest {
  SharedGraph graph = {};
  Json parameters = Json::object();
  std::vector<std::string> of = {};  ///< places of numbers, vectors, points or meshes
  std::vector<std::string> by = {};  ///< parameters; empty: all that are numbers
};

/// The body of POST /v1/gradient.
struct GradientBody : GradientRequest {
  std::optional<std::int64_t> deadline_milliseconds = {};
};

const RequestDescription& fit_description();
const RequestDescription& gradient_description();

// What such a body says. Its graph is read by the engine.
Result<FitBody> read_fit_body(Json body, const Engine& engine);
Result<GradientBody> read_gradient_body(Json body, const Engine& engine);

}  // namespace dini

#pragma once

#include <string>
#include <vector>

#include "graph/job.h"
#include "service/requests/fit_request.h"
#include "service/value_source.h"

namespace dini::fitting {

/// How all numbers of one output grow with one parameter.
struct Derivative {
  std::vector<double> slopes;  ///< number by number; of a mesh, all coordinates of all vertices
  double error = 0;            ///< none of them is farther from the true one, as far as differences can tell
};

/// One output with its derivatives.
struct Differentiated {
  std::string place;
  Value value;
  std::vector<Derivative> by;  ///< as the parameters
};

/// Derivatives of outputs by parameters at one setting.
struct Gradient {
  std::vector<std::string> parameters;
  std::vector<double> at;
  std::vector<double> ranges;  ///< of the parameters; their size, or 1, where they have no two bounds
  std::vector<Differentiated> outputs;
};

/// The predicted memory of a gradient with all of its evaluations, or what can be told to be wrong without evaluating.
Result<std::size_t> check(const Engine& engine, const GradientRequest& request, const Cancel& cancel);

/// By differences over two steps, the shorter one half of the longer, from which the better value and its error follow
/// (Richardson); on one side of a parameter that is at a bound. Evaluations are one family as far as the limit of
/// memory lets them. Problems name the member of the request, or are those of the graph.
Result<Gradient> gradient(const Engine& engine, const GradientRequest& request, const Cancel& cancel);

/// The schema `Gradient`.
Json to_json(const Gradient& gradient);

/// The meshes of a gradient by one parameter, as a GLB in which each vertex has the color of how fast it moves: dark
/// where it rests, yellow where it is fastest. `asset.extras.gradient` has the parameter and the greatest speed, in
/// meters for a unit of the parameter. Problems: several parameters, nothing that is a mesh, and those of the encoder.
Result<std::string> colored(const Gradient& gradient, const Cancel& cancel);

}  // namespace dini::fitting

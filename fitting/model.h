#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/mesh_goal.h"
#include "fitting/varied.h"
#include "service/requests/fit_request.h"
#include "service/value_source.h"

namespace dini::fitting {

/// Numbers that are wanted at an output, in its order, each component of a point being one.
struct NumberGoal {
  std::string place;
  std::vector<double> wanted;
  double size = 1;  ///< what is missing is counted in proportion to this: the largest of them, or 1
};

/// What a setting comes to.
struct Sample {
  std::vector<std::vector<double>> numbers;  ///< at each target, then at each output to minimize
  Surface surface;                           ///< of the output that is to be like the mesh; else empty
  std::vector<Foot> feet;
  double minimized = 0;            ///< sum of what is to be minimized, each in proportion to what it was at first
  std::vector<double> conditions;  ///< what is missing at the targets
  std::vector<double> distances;   ///< residuals of the feet
};

/// How all this grows with each parameter, on the scale of places.
struct Slopes {
  std::vector<double> minimized;
  std::vector<std::vector<double>> conditions, distances;  ///< by parameter
};

/// A graph, its varied parameters and what is to come of it: what optimizers ask.
class Model {
 public:
  /// Reads a request without evaluating. Problems name its member, with what would be accepted. `cancel` must outlive
  /// the model.
  static Result<Model> read(const Engine& engine, const FitRequest& request, const Cancel& cancel);

  /// Evaluates the first place, by which things to be minimized are weighed; to be done once.
  Result<Sample> begin();

  /// The memory that so many evaluations take, or those of a derivative where these are more: of the graph as one
  /// family, and of what is measured. Else what the check of the graph says.
  Result<std::size_t> memory(const Engine& engine, std::size_t together) const;

  const std::vector<Varied>& varied() const { return varied_; }
  const std::vector<NumberGoal>& targets() const { return targets_; }
  const std::vector<std::string>& minimized() const { return minimized_; }
  const std::optional<MeshGoal>& mesh() const { return mesh_; }

  /// What several places come to; the problems are those of that place alone.
  std::vector<Result<Sample>> at(const std::vector<Place>& places);

  /// How a sample grows: by differences of one evaluation for each parameter, all as one family. A parameter whose
  /// step fails, or changes how many vertices there are, has slopes of zero.
  Slopes slopes(const Place& place, const Sample& sample);

  /// How often the graph was evaluated so far.
  std::int64_t evaluations() const { return evaluations_; }

 private:
  Model(const ValueSource& source, const Cancel& cancel) : source_(&source), cancel_(&cancel) {}

  /// The member of the request that a place stands in, and problems of places with their pointers there.
  std::string pointer_to(std::size_t place) const;
  Problems at_own_places(Problems problems) const;
  Result<Sample> sample_of(const std::vector<Value>& values) const;
  std::vector<SettingValues> values_at(const std::vector<Place>& places);

  const ValueSource* source_;
  const Cancel* cancel_;
  ValuesRequest request_;
  std::vector<Varied> varied_;
  std::vector<NumberGoal> targets_;
  std::vector<std::string> minimized_;
  std::vector<double> sizes_;  ///< of what is minimized, at first
  std::optional<MeshGoal> mesh_;
  std::int64_t evaluations_ = 0;
};

/// The predicted memory of one evaluation for these places, or what the check of the graph says of it.
Result<std::size_t> memory_of_one(const Engine& engine, const ValuesRequest& request, const Json& setting,
                                  const Cancel& cancel);

/// The numbers of a value: those of numbers, and all components of vectors and points; nothing for another type.
std::optional<std::vector<double>> numbers_of(const Value& value);

/// All meshes of a value as one.
Surface surface_of(const Value& value);

}  // namespace dini::fitting

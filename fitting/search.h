#pragma once

#include <limits>
#include <optional>

#include "fitting/fit.h"
#include "fitting/matrix.h"
#include "fitting/model.h"

namespace dini::fitting {

/// How good a place is. Conditions come first: what misses them is worse than what keeps them.
struct Merit {
  double missing = std::numeric_limits<double>::infinity();    ///< how far conditions are from holding
  double objective = std::numeric_limits<double>::infinity();  ///< what is to be small

  bool is_better_than(const Merit& other) const;
};

/// A place that was looked at.
struct Found {
  Place place;
  Merit merit;
  Sample sample;
};

/// One fit as its optimizers see it: it knows what was asked last, the best of all, and when to stop.
class Search {
 public:
  /// So many places are evaluated at once where starts are looked for.
  static constexpr std::size_t evaluated_together = 16;

  /// `first` is what the model began with at its first place.
  Search(Model& model, const FitRequest& request, Sample first, const Job& job, const FitTerms& terms);

  /// Whether conditions are kept beside something to minimize, instead of being part of the sum of squares.
  bool has_conditions() const { return !model_.minimized().empty() && !model_.targets().empty(); }

  /// Where else to begin than at the given place: the best of others that are spread over the bounds.
  std::vector<Place> other_starts();

  /// Goes downhill from a place; the best of what it met.
  std::optional<Found> descend(const Place& start);

  /// Nothing more is evaluated: the deadline or the number of evaluations is reached, or somebody stopped it.
  bool stopped() const;
  bool ran_out_of_time() const;
  /// More evaluations were wanted than are left.
  bool ran_out_of_evaluations() const { return ran_out_; }

  const Found& best() const { return *best_; }
  /// How sharply what is asked rises at the best place or, beside something to minimize, anywhere on the way.
  SymmetricMatrix rise();

 private:
  /// Whether so many evaluations may still be made.
  bool has_left(std::size_t evaluations);
  Merit merit_of(const Sample& sample) const;
  const Sample* sample_at(const Place& place);
  const Slopes& slopes_at(const Place& place, const Sample& sample);
  void consider(const Place& place, const Sample& sample);
  void tell_progress();
  Place downhill(const Place& start);
  Place to_the_end(const Place& start);

  Model& model_;
  const Job& job_;
  const FitTerms& terms_;
  const std::int64_t starts_, most_evaluations_;
  std::int64_t told_ = 0;
  bool ran_out_ = false;
  std::optional<Place> last_place_;
  std::optional<Sample> last_sample_;
  std::optional<Place> slopes_place_;
  Slopes slopes_;
  std::optional<Found> best_, best_of_start_;
  SymmetricMatrix seen_;
};

}  // namespace dini::fitting

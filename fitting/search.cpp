#include "fitting/search.h"

#include <algorithm>
#include <cmath>

#include "fitting/least_squares.h"
#include "fitting/minimize.h"

namespace dini::fitting {
namespace {

/// So many places are looked at for each start but the first.
constexpr std::size_t places_per_start = 16;

/// Conditions that are missed by no more count as kept. Less is still better, at this price.
constexpr double kept = 1e-6;
constexpr double price = 100;

/// Points that fill the unit cube evenly: multiples of the powers of the root of x^(n+1) = x + 1, as in one dimension
/// those of the golden ratio (M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018).
std::vector<Place> spread(std::size_t dimensions, std::size_t count) {
  double root = 1.5;
  for (int step = 0; step < 60; ++step) {
    double power = 1;
    for (std::size_t k = 0; k < dimensions; ++k) power *= root;
    const double slope = static_cast<double>(dimensions + 1) * power - 1;
    root -= (power * root - root - 1) / slope;
  }
  std::vector<Place> places;
  for (std::size_t i = 1; i <= count; ++i) {
    Place place(dimensions);
    double share = 1;
    for (double& coordinate : place) {
      share /= root;
      const double far = 0.5 + static_cast<double>(i) * share;
      coordinate = far - std::floor(far);
    }
    places.push_back(std::move(place));
  }
  return places;
}

/// Slopes of a place of which none are known.
Slopes flat(std::size_t parameters, const Sample& sample) {
  return {std::vector<double>(parameters),
          {parameters, std::vector<double>(sample.conditions.size())},
          {parameters, std::vector<double>(sample.distances.size())}};
}

/// Directions at right angles, of length 1, along which these slopes go: as many as there are independent ones.
std::vector<std::vector<double>> directions(std::vector<std::vector<double>> slopes) {
  constexpr double independent = 1e-6;
  std::vector<std::vector<double>> found;
  for (std::vector<double>& slope : slopes) {
    const double before = std::sqrt(dot_product(slope, slope));
    for (const std::vector<double>& direction : found) {
      const double share = dot_product(slope, direction);
      for (std::size_t i = 0; i < slope.size(); ++i) slope[i] -= share * direction[i];
    }
    const double size = std::sqrt(dot_product(slope, slope));
    if (!(size > independent * before)) continue;
    for (double& each : slope) each /= size;
    found.push_back(std::move(slope));
  }
  return found;
}

/// What a graph that fails is worth: more than anything, and still a number to go back from.
double beyond(double first) { return 1e6 * (1 + std::abs(first)); }

}  // namespace

bool Merit::is_better_than(const Merit& other) const {
  const bool keeps = missing <= kept, other_keeps = other.missing <= kept;
  if (keeps && other_keeps) return objective + price * missing < other.objective + price * other.missing;
  return missing < other.missing;
}

Search::Search(Model& model, const FitRequest& request, Sample first, const Job& job, const FitTerms& terms)
    : model_(model),
      job_(job),
      terms_(terms),
      starts_(request.starts),
      most_evaluations_(request.evaluations),
      last_place_(start_of(model.varied())),
      last_sample_(std::move(first)),
      seen_(model.varied().size()) {
  job_.progress.announce(static_cast<double>(most_evaluations_));
  tell_progress();
  consider(*last_place_, *last_sample_);
}

bool Search::ran_out_of_time() const {
  return Cancel::Clock::now() >= terms_.deadline || job_.cancel.reason() == StopReason::deadline;
}

bool Search::stopped() const { return job_.cancel.stopped() || ran_out_of_time() || ran_out_; }

bool Search::has_left(std::size_t evaluations) {
  const bool has = model_.evaluations() + static_cast<std::int64_t>(evaluations) <= most_evaluations_;
  ran_out_ = ran_out_ || !has;
  return has;
}

Merit Search::merit_of(const Sample& sample) const {
  const double missing = dot_product(sample.conditions, sample.conditions);
  const double objective = sample.minimized + dot_product(sample.distances, sample.distances);
  if (has_conditions()) return {std::sqrt(missing), objective};
  return {0, objective + missing};
}

void Search::consider(const Place& place, const Sample& sample) {
  const Merit merit = merit_of(sample);
  if (!best_of_start_ || merit.is_better_than(best_of_start_->merit)) best_of_start_ = {place, merit, sample};
  if (best_ && !merit.is_better_than(best_->merit)) return;
  best_ = {place, merit, sample};
  if (terms_.improved) {
    Json best = {{"parameters", setting_at(model_.varied(), place)}, {"objective", merit.objective}};
    if (has_conditions()) best["missing"] = merit.missing;
    terms_.improved(best);
  }
}

void Search::tell_progress() {
  const std::int64_t now = std::min(model_.evaluations(), most_evaluations_);
  job_.progress.add(static_cast<double>(now - told_));
  told_ = now;
}

const Sample* Search::sample_at(const Place& place) {
  if (last_place_ != place) {
    if (!has_left(1)) return nullptr;
    Result<Sample> sample = std::move(model_.at({place}).front());
    last_place_ = place;
    last_sample_ = sample ? std::optional(*std::move(sample)) : std::nullopt;
    tell_progress();
    if (last_sample_) consider(place, *last_sample_);
  }
  return last_sample_ ? &*last_sample_ : nullptr;
}

const Slopes& Search::slopes_at(const Place& place, const Sample& sample) {
  if (slopes_place_ == place) return slopes_;
  if (!has_left(place.size())) {
    slopes_ = flat(place.size(), sample);
    slopes_place_ = std::nullopt;
    return slopes_;
  }
  slopes_ = model_.slopes(place, sample);
  slopes_place_ = place;
  tell_progress();
  for (std::size_t i = 0; i < place.size(); ++i) {
    for (std::size_t j = 0; j < place.size(); ++j) {
      seen_(i, j) += slopes_.minimized[i] * slopes_.minimized[j] +
                     dot_product(slopes_.conditions[i], slopes_.conditions[j]) +
                     dot_product(slopes_.distances[i], slopes_.distances[j]);
    }
  }
  return slopes_;
}

std::vector<Place> Search::other_starts() {
  std::vector<Place> starts;
  const std::size_t more = static_cast<std::size_t>(starts_ - 1);
  const std::vector<Place> places = spread(model_.varied().size(), places_per_start * more);
  std::vector<std::pair<Merit, Place>> looked;
  for (std::size_t first = 0; first < places.size() && !stopped();) {
    const auto left = static_cast<std::size_t>(std::max<std::int64_t>(0, most_evaluations_ - model_.evaluations()));
    if (!has_left(1)) break;
    const auto end = std::min({places.size(), first + evaluated_together, first + left});
    const std::vector<Place> some(places.begin() + static_cast<std::ptrdiff_t>(first),
                                  places.begin() + static_cast<std::ptrdiff_t>(end));
    const std::vector<Result<Sample>> samples = model_.at(some);
    for (std::size_t k = 0; k < some.size(); ++k) {
      if (samples[k]) looked.emplace_back(merit_of(*samples[k]), some[k]);
      if (samples[k]) consider(some[k], *samples[k]);
    }
    first = end;
    tell_progress();
  }
  std::ranges::stable_sort(looked, [](const auto& a, const auto& b) { return a.first.is_better_than(b.first); });
  for (std::size_t k = 0; k < std::min(more, looked.size()); ++k) starts.push_back(looked[k].second);
  return starts;
}

Place Search::downhill(const Place& start) {
  const Sample* const first = sample_at(start);
  if (first == nullptr) return start;
  const double first_value = merit_of(*first).objective;
  // The optimizer takes its first step as if slopes were about 1.
  const double scale = model_.minimized().empty() ? 1 / std::max(first_value, 1e-30) : 1;
  const std::size_t count = start.size();
  Objective objective;
  // Where squares are summed, the end of the way is for those who know that.
  objective.least_gain = model_.minimized().empty() ? 0.05 : 0;
  objective.stopped = [this] { return stopped(); };
  objective.value = [&](const Place& place, std::span<double> wanted) {
    std::ranges::fill(wanted, 0.0);
    const Sample* sample = sample_at(place);
    if (sample == nullptr) return beyond(scale * first_value);
    if (!wanted.empty()) {
      const Slopes& slopes = slopes_at(place, *sample);
      for (std::size_t k = 0; k < count; ++k) {
        double slope = slopes.minimized[k] + 2 * dot_product(slopes.distances[k], sample->distances);
        if (!has_conditions()) slope += 2 * dot_product(slopes.conditions[k], sample->conditions);
        wanted[k] = scale * slope;
      }
    }
    return scale * merit_of(*sample).objective;
  };
  // No more conditions can be kept than there are parameters, and the optimizer takes no more: of more there are
  // combinations, along the directions in which they rise at first.
  const bool are_combined = has_conditions() && first->conditions.size() > count;
  std::vector<std::vector<double>> combinations;
  if (are_combined) combinations = directions(slopes_at(start, *first).conditions);
  objective.conditions = !has_conditions() ? 0 : are_combined ? combinations.size() : first->conditions.size();
  const auto combined = [&](const std::vector<double>& conditions, std::size_t i) {
    return are_combined ? dot_product(combinations[i], conditions) : conditions[i];
  };
  objective.missing = [&](const Place& place, std::span<double> values, std::span<double> wanted) {
    const Sample* sample = sample_at(place);
    if (sample == nullptr) {
      std::ranges::fill(values, 1.0);
      return;
    }
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = combined(sample->conditions, i);
    if (wanted.empty()) return;
    const Slopes& slopes = slopes_at(place, *sample);
    for (std::size_t i = 0; i < values.size(); ++i) {
      for (std::size_t k = 0; k < count; ++k) wanted[i * count + k] = combined(slopes.conditions[k], i);
    }
  };
  return minimize(objective, start);
}

Place Search::to_the_end(const Place& start) {
  const auto together = [](std::vector<double> a, const std::vector<double>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  const SquaresProblem problem{.values = [&](const Place& place) -> std::optional<std::vector<double>> {
                                 const Sample* sample = sample_at(place);
                                 if (sample == nullptr) return std::nullopt;
                                 return together(sample->conditions, sample->distances);
                               },
                               .slopes =
                                   [&](const Place& place) {
                                     const Sample* sample = sample_at(place);
                                     const Slopes& slopes = slopes_at(place, *sample);
                                     std::vector<std::vector<double>> all;
                                     for (std::size_t k = 0; k < place.size(); ++k) {
                                       all.push_back(together(slopes.conditions[k], slopes.distances[k]));
                                     }
                                     return all;
                                   },
                               .stopped = [this] { return stopped(); }};
  return least_squares(problem, start);
}

std::optional<Found> Search::descend(const Place& start) {
  best_of_start_ = std::nullopt;
  if (stopped()) return std::nullopt;
  if (sample_at(start) != nullptr) consider(start, *last_sample_);
  downhill(start);
  if (model_.minimized().empty() && best_of_start_) to_the_end(Place(best_of_start_->place));
  return best_of_start_;
}

SymmetricMatrix Search::rise() {
  if (!model_.minimized().empty()) return seen_;
  if (slopes_place_ != best_->place && !has_left(model_.varied().size())) return seen_;
  const Slopes slopes = slopes_place_ == best_->place ? slopes_ : model_.slopes(best_->place, best_->sample);
  SymmetricMatrix rise = normal_matrix(slopes.conditions);
  const SymmetricMatrix more = normal_matrix(slopes.distances);
  for (std::size_t i = 0; i < rise.size(); ++i) {
    for (std::size_t j = 0; j < rise.size(); ++j) rise(i, j) += more(i, j);
  }
  return rise;
}

}  // namespace dini::fitting

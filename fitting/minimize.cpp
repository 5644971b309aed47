#include "fitting/minimize.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <nlopt.h>

namespace dini::fitting {
namespace {

constexpr double least_step = 1e-9;
constexpr double condition_tolerance = 1e-9;
constexpr int most_steps = 200;

/// What the callbacks see. No exception may go through the library, which is C, so one waits here until it is over.
struct Run {
  const Objective& objective;
  nlopt_opt optimizer = nullptr;
  std::exception_ptr thrown = nullptr;

  template <class Step>
  void guarded(Step step) {
    try {
      if (objective.stopped()) {
        nlopt_force_stop(optimizer);
      } else {
        step();
      }
    } catch (...) {
      thrown = std::current_exception();
      nlopt_force_stop(optimizer);
    }
  }
};

double value_for_library(unsigned count, const double* place, double* slopes, void* data) {
  Run& run = *static_cast<Run*>(data);
  double value = 0;
  run.guarded([&] {
    const std::span<double> wanted = slopes != nullptr ? std::span(slopes, count) : std::span<double>();
    value = run.objective.value(Place(place, place + count), wanted);
  });
  return value;
}

void conditions_for_library(unsigned conditions, double* values, unsigned count, const double* place, double* slopes,
                            void* data) {
  Run& run = *static_cast<Run*>(data);
  const std::span<double> told(values, conditions);
  std::ranges::fill(told, 0.0);
  run.guarded([&] {
    const std::size_t size = std::size_t{conditions} * count;
    const std::span<double> wanted = slopes != nullptr ? std::span(slopes, size) : std::span<double>();
    run.objective.missing(Place(place, place + count), told, wanted);
  });
}

}  // namespace

Place minimize(const Objective& objective, const Place& start) {
  const auto count = static_cast<unsigned>(start.size());
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> optimizer(nlopt_create(NLOPT_LD_SLSQP, count), nlopt_destroy);
  if (optimizer == nullptr) throw std::bad_alloc();
  Run run{objective, optimizer.get()};
  nlopt_set_lower_bounds1(optimizer.get(), 0);
  nlopt_set_upper_bounds1(optimizer.get(), 1);
  nlopt_set_min_objective(optimizer.get(), value_for_library, &run);
  if (objective.conditions > 0) {
    const std::vector<double> tolerances(objective.conditions, condition_tolerance);
    nlopt_add_equality_mconstraint(optimizer.get(), static_cast<unsigned>(objective.conditions), conditions_for_library,
                                   &run, tolerances.data());
  }
  nlopt_set_xtol_abs1(optimizer.get(), least_step);
  nlopt_set_ftol_rel(optimizer.get(), objective.least_gain);
  nlopt_set_maxeval(optimizer.get(), most_steps);
  Place place = start;
  double value = 0;
  // Its code says why it ended, which whoever asks sees from the places that were asked for.
  nlopt_optimize(optimizer.get(), place.data(), &value);
  if (run.thrown) std::rethrow_exception(run.thrown);
  return place;
}

}  // namespace dini::fitting

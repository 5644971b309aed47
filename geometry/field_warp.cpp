#include "geometry/field_warp.h"

#include <algorithm>
#include <cmath>

#include "algebra/elementary.h"
#include "algebra/frame.h"
#include "algebra/versor.h"

namespace dini {

namespace {

/// A generator of a warp, and how fast it moves what is at a distance r from it, at most: r^2 boost + r turn + shift.
struct Pull {
  kernels::WarpSource source;
  double boost, turn, shift;

  double speed(double r) const { return (boost * r + turn) * r + shift; }
  /// How much faster it moves what is farther away; also the most that it stretches in a unit of time.
  double growth(double r) const { return 2 * boost * r + turn; }
};

Pull pull_of(const kernels::WarpSource& source) {
  const Generator own = seen_from(source.generator, to_vector(source.position));
  return {source, length(own.no_e), 2 * std::sqrt(own.no_ni * own.no_ni + squared_length(own.e_e)),
          2 * length(own.e_ni)};
}

/// Where a place is taken to, and by how much lengths shrink there.
struct PulledBack {
  Vector place;
  double weight = 1;
};

class WarpedField : public ScalarField {
 public:
  WarpedField(SharedField field, std::shared_ptr<const std::vector<Pull>> pulls, double strength, double power,
              double softening, FieldSize size)
      : ScalarField(size, std::nullopt),
        field_(std::move(field)),
        pulls_(std::move(pulls)),
        strength_(strength),
        power_(power),
        softening_(softening) {}

  void values(const Places& at, double* out) const override {
    std::vector<double> carried(4 * at.count);
    double *x = carried.data(), *y = x + at.count, *z = y + at.count, *weights = z + at.count;
    for (std::size_t i = 0; i < at.count; ++i) {
      const PulledBack back = pulled_back({at.x[i], at.y[i], at.z[i]});
      x[i] = back.place.x, y[i] = back.place.y, z[i] = back.place.z, weights[i] = back.weight;
    }
    field_->values({x, y, z, at.count}, out);
    for (std::size_t i = 0; i < at.count; ++i) out[i] *= weights[i];
  }

  /// The gradient goes through the map by differences.
  Slope slope(const Vector& at) const override {
    constexpr double share = 1e-6;
    const double step = share * std::max(distance_to_generators(at), 1e-9);
    const PulledBack back = pulled_back(at);
    const Slope there = field_->slope(back.place);
    const auto along = [&](const Vector& axis) {
      const PulledBack ahead = pulled_back(at + step * axis), behind = pulled_back(at - step * axis);
      const Vector moved = (ahead.place - behind.place) / (2 * step);
      return back.weight * dot(there.gradient, moved) + there.value * ((ahead.weight - behind.weight) / (2 * step));
    };
    return {back.weight * there.value, {along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})}};
  }

  Narrowed narrowed(const SolidBall& ball, const SharedField& self) const override {
    const std::optional<Spread> spread = spread_of(ball);
    if (!spread) return {{}, self};
    const PulledBack middle = pulled_back(ball.center);
    Narrowed one = field_->narrowed({middle.place, spread->radius}, field_);
    const double most = middle.weight * spread->stretch, least = middle.weight / spread->stretch;
    const double low = one.values.low, high = one.values.high;
    const Interval values{low * (low > 0 ? least : most), high * (high > 0 ? most : least)};
    if (one.field == field_) return {values, self};
    FieldSize size = this->size();
    return {values, std::make_shared<WarpedField>(std::move(one.field), pulls_, strength_, power_, softening_, size)};
  }

  std::string formula() const override { return "warped(" + field_->formula() + ")"; }

 private:
  /// What the pull back makes of a ball: a ball about the image of the center, and the factor between conformal factors
  /// in it and the one at the center, at most.
  struct Spread {
    double radius, stretch;
  };

  double to_power(double distance) const {
    return power_ == 2 ? distance * distance : elementary::pow(distance, power_);
  }

  double distance_to_generators(const Vector& at) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Pull& pull : *pulls_) nearest = std::min(nearest, length(at - to_vector(pull.source.position)));
    return std::isfinite(nearest) ? nearest : 1;
  }

  /// The sum of the generators as it is at a place, per unit of strength; nothing where a place stays.
  std::optional<Generator> sum_at(const Vector& at) const {
    Generator sum;
    for (const Pull& pull : *pulls_) {
      const double weight = 1 / (to_power(length(at - to_vector(pull.source.position))) + softening_);
      if (!std::isfinite(weight)) return std::nullopt;
      sum = sum + weight * pull.source.generator;
    }
    return sum;
  }

  PulledBack pulled_back(const Vector& at) const {
    constexpr double smallest = 1e-100;
    const std::optional<Generator> sum = sum_at(at);
    if (!sum) return {at, 1};
    const Sphere image = apply(exponential(-strength_ * *sum), Sphere{1, at, 0.5 * squared_length(at)});
    const double weight = std::max(image.no, smallest);
    const Vector place = image.e / weight;
    return is_finite(place) && std::isfinite(weight) ? PulledBack{place, weight} : PulledBack{at, 1};
  }

  /// The center goes along its orbit in steps. A place of the ball has other weights, and so drifts off by what the
  /// generators can move it in that time, times by how much their flow pulls apart what it carries (Gronwall). Nothing
  /// where no bound is found: too near to a generator, or so strong that the ball may reach infinity.
  std::optional<Spread> spread_of(const SolidBall& ball) const {
    constexpr int steps = 16;
    const std::optional<Generator> sum = sum_at(ball.center);
    if (!sum) return std::nullopt;
    struct Change {
      double most, slope;  ///< of the weight in the ball
    };
    std::vector<Change> changes;
    for (const Pull& pull : *pulls_) {
      const double middle = length(ball.center - to_vector(pull.source.position));
      const double near = std::max(0.0, middle - ball.radius), far = middle + ball.radius;
      const double most = 1 / (to_power(near) + softening_);
      const double steepest = power_ == 0 ? 0 : power_ * std::max(to_power(near) / near, to_power(far) / far);
      const double slope = steepest * most * most;
      if (!std::isfinite(most) || !std::isfinite(slope)) return std::nullopt;
      changes.push_back({std::abs(strength_) * most, std::abs(strength_) * slope * ball.radius});
    }
    const Versor step = exponential((-strength_ / steps) * *sum);
    Point place = to_point(ball.center);
    double radius = ball.radius, logarithm = 0;
    for (int k = 0; k < steps; ++k) {
      const std::optional<Point> next = apply(step, place);
      if (!next || !is_finite(*next)) return std::nullopt;
      const double way = length(to_vector(*next) - to_vector(place)) + 2 * radius;
      double drift = 0, growth = 0, stretch = 0;
      for (std::size_t i = 0; i < changes.size(); ++i) {
        const Pull& pull = (*pulls_)[i];
        const double reach = length(to_vector(place) - to_vector(pull.source.position)) + way;
        drift += changes[i].slope * pull.speed(reach);
        growth += changes[i].most * pull.growth(reach);
        stretch += changes[i].slope * pull.growth(reach) + changes[i].most * 4 * pull.boost * radius;
      }
      if (!(growth < 700.0 * steps)) return std::nullopt;
      const double after = (radius + drift / steps) * elementary::exp(growth / steps);
      if (!(after <= 2 * radius)) return std::nullopt;
      radius = after;
      logarithm += stretch / steps;
      place = *next;
    }
    if (!(logarithm < 300)) return std::nullopt;
    return Spread{radius, elementary::exp(logarithm)};
  }

  SharedField field_;
  std::shared_ptr<const std::vector<Pull>> pulls_;
  double strength_, power_, softening_;
};

}  // namespace

SharedField warped_field(SharedField field, std::vector<kernels::WarpSource> sources, double strength, double power,
                         double softening) {
  auto pulls = std::make_shared<std::vector<Pull>>();
  pulls->reserve(sources.size());
  for (const kernels::WarpSource& source : sources) pulls->push_back(pull_of(source));
  FieldSize size = size_over({field}, sizeof(WarpedField) + pulls->size() * sizeof(Pull));
  size.operations += pulls->size();
  return std::make_shared<WarpedField>(std::move(field), std::move(pulls), strength, power, softening, size);
}

}  // namespace dini

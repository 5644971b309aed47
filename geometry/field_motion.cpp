#include "geometry/field_motion.h"

#include <algorithm>
#include <cmath>

#include "algebra/versor.h"

namespace dini {

namespace {

/// Where a conformal map takes the point x: to (origin + matrix x + square x^2/2) / weight, where weight is
/// weight_origin + weight_slope.x + weight_square x^2/2, which is above zero but at the point that goes to infinity.
/// Lengths at x shrink by the weight.
struct ConformalMap {
  Sphere origin, x, y, z, infinity;  ///< the images of no, e1, e2, e3, ni
};

template <class Number>
Number weight_of(const ConformalMap& map, const PlaceOf<Number>& p, const Number& half_square) {
  return map.origin.no + (map.x.no * p.x + map.y.no * p.y + map.z.no * p.z + map.infinity.no * half_square);
}

template <class Number>
Number image_of(double origin, const Vector& row, double square, const PlaceOf<Number>& p, const Number& half_square) {
  return origin + (dot(row, p) + square * half_square);
}

/// A weight is rounded to zero, or below, only at the point that goes to infinity, which then goes very far instead.
constexpr double least_weight = 1e-100;

template <class Number>
Number above_zero(const Number& weight) {
  if (value_of(weight) > least_weight) return weight;
  Number least{};
  return least + least_weight;
}

std::optional<ConformalMap> map_of(const Versor& versor) {
  if (!is_versor(versor) || !has_inverse(versor)) return std::nullopt;
  ConformalMap map{apply(versor, Sphere{1, {}, 0}), apply(versor, Sphere{0, {1, 0, 0}, 0}),
                   apply(versor, Sphere{0, {0, 1, 0}, 0}), apply(versor, Sphere{0, {0, 0, 1}, 0}),
                   apply(versor, Sphere{0, {}, 1})};
  // The weight is a square but for one sign, and infinity has as much of it as any place.
  const double sign = map.origin.no + map.infinity.no < 0 ? -1 : 1;
  for (Sphere* image : {&map.origin, &map.x, &map.y, &map.z, &map.infinity}) {
    *image = {sign * image->no, sign * image->e, sign * image->ni};
    if (!std::isfinite(image->no) || !is_finite(image->e) || !std::isfinite(image->ni)) return std::nullopt;
  }
  map.infinity.no = std::max(0.0, map.infinity.no);
  return map;
}

/// The distance from the image of a ball, outside of it; zero and less inside. With the image of its sphere as dual
/// vector over its radius, q = power of the place over the diameter, and curvature = one over the radius, which is
/// negative where the ball was turned inside out: 2 q / (1 + sqrt(1 + 2 q curvature)).
struct CarriedBall {
  Sphere sphere;

  template <class Number>
  Number distance(const PlaceOf<Number>& p) const {
    const Number q = sphere.no * (0.5 * square(p)) - dot(sphere.e, p) + sphere.ni;
    const Number inner = (2 * sphere.no) * q + 1.0;
    if (value_of(q) <= 0 || value_of(inner) <= 0) return 2.0 * q;
    return (2.0 * q) / (root(inner) + 1.0);
  }
};

class MovedField : public ScalarField {
 public:
  struct Motion {
    ConformalMap back;  ///< from the carried solid to the one that is given
    double pull;        ///< half the weight's square term: how far from a similarity the map is
    std::optional<CarriedBall> reach;
    double outside = 1;
  };

  MovedField(SharedField field, const Motion& motion, std::optional<Reach> reach)
      : ScalarField(size_over({field}, sizeof(*this)), reach), field_(std::move(field)), motion_(motion) {}

  void values(const Places& at, double* out) const override {
    std::vector<double> carried(4 * at.count);
    double *x = carried.data(), *y = x + at.count, *z = y + at.count, *weights = z + at.count;
    for (std::size_t i = 0; i < at.count; ++i) {
      const PlaceOf<double> place{at.x[i], at.y[i], at.z[i]};
      const Image<double> image = carry(place);
      x[i] = image.place.x, y[i] = image.place.y, z[i] = image.place.z, weights[i] = image.weight;
    }
    field_->values({x, y, z, at.count}, out);
    for (std::size_t i = 0; i < at.count; ++i) {
      out[i] = distance(out[i], weights[i], PlaceOf<double>{at.x[i], at.y[i], at.z[i]});
    }
  }

  Slope slope(const Vector& at) const override {
    const PlaceOf<Slope> place = sloped(at);
    const Image<Slope> image = carry(place);
    const Slope there = field_->slope({image.place.x.value, image.place.y.value, image.place.z.value});
    const Slope value{there.value, there.gradient.x * image.place.x.gradient +
                                       there.gradient.y * image.place.y.gradient +
                                       there.gradient.z * image.place.z.gradient};
    return distance(value, image.weight, place);
  }

  Narrowed narrowed(const SolidBall& ball, const SharedField& self) const override {
    const PlaceOf<double> center{ball.center.x, ball.center.y, ball.center.z};
    double away = 0;  // how far all of the ball is from the carried reach, at least
    double farthest = 0;
    if (motion_.reach) {
      const double middle = motion_.reach->distance(center);
      away = middle - ball.radius;
      farthest = middle + ball.radius;
    }
    const std::optional<SolidBall> image = image_of_ball(ball);
    if (!image) return {within_reach({}, away, farthest), self};
    Narrowed one = field_->narrowed(*image, field_);
    const auto [least, most] = weights_in(ball);
    const double low = scaled(one.values.low, one.values.low > 0 ? least : most);
    const double high = scaled(one.values.high, one.values.high > 0 ? most : least);
    const Interval values = within_reach({low, high}, away, farthest);
    if (one.field == field_) return {values, self};
    return {values, std::make_shared<MovedField>(std::move(one.field), motion_, reach())};
  }

  std::string formula() const override { return "moved(" + field_->formula() + ")"; }

 private:
  template <class Number>
  struct Image {
    PlaceOf<Number> place;
    Number weight;
  };

  template <class Number>
  Image<Number> carry(const PlaceOf<Number>& p) const {
    const ConformalMap& map = motion_.back;
    const Number half_square = 0.5 * square(p);
    const Number weight = above_zero(weight_of(map, p, half_square));
    const auto coordinate = [&](double origin, const Vector& row, double square) {
      return image_of(origin, row, square, p, half_square) / weight;
    };
    return {{coordinate(map.origin.e.x, {map.x.e.x, map.y.e.x, map.z.e.x}, map.infinity.e.x),
             coordinate(map.origin.e.y, {map.x.e.y, map.y.e.y, map.z.e.y}, map.infinity.e.y),
             coordinate(map.origin.e.z, {map.x.e.z, map.y.e.z, map.z.e.z}, map.infinity.e.z)},
            weight};
  }

  /// The least distance of the border of the image of a ball of radius |value| about the carried place.
  template <class Number>
  Number scaled(const Number& value, const Number& weight) const {
    if (!std::isfinite(value_of(value))) return value;
    return (weight * value) / (magnitude(value) * root(motion_.pull * weight) + 1.0);
  }

  template <class Number>
  Number distance(const Number& value, const Number& weight, const PlaceOf<Number>& place) const {
    const Number near = scaled(value, weight);
    if (!motion_.reach) return near;
    const Number far = motion_.reach->distance(place);
    if (value_of(far) > 0 && value_of(far) > value_of(magnitude(near))) return motion_.outside * far;
    return near;
  }

  Interval within_reach(Interval values, double away, double farthest) const {
    if (!motion_.reach) return values;
    if (away > 0) {
      return motion_.outside > 0 ? Interval{std::max(values.low, away), std::max(values.high, farthest)}
                                 : Interval{std::min(values.low, -farthest), std::min(values.high, -away)};
    }
    if (farthest <= 0) return values;
    return motion_.outside > 0 ? Interval{values.low, std::max(values.high, farthest)}
                               : Interval{std::min(values.low, -farthest), values.high};
  }

  /// Nothing when the ball holds the point that goes to infinity.
  std::optional<SolidBall> image_of_ball(const SolidBall& ball) const {
    const Vector& c = ball.center;
    const double power = 0.5 * (squared_length(c) - ball.radius * ball.radius);
    const PlaceOf<double> place{c.x, c.y, c.z};
    const ConformalMap& map = motion_.back;
    const double weight = weight_of(map, place, power);
    if (!(weight > least_weight)) return std::nullopt;
    const auto coordinate = [&](double origin, const Vector& row, double square) {
      return image_of(origin, row, square, place, power) / weight;
    };
    const SolidBall image{{coordinate(map.origin.e.x, {map.x.e.x, map.y.e.x, map.z.e.x}, map.infinity.e.x),
                           coordinate(map.origin.e.y, {map.x.e.y, map.y.e.y, map.z.e.y}, map.infinity.e.y),
                           coordinate(map.origin.e.z, {map.x.e.z, map.y.e.z, map.z.e.z}, map.infinity.e.z)},
                          ball.radius / weight};
    if (!is_finite(image.center) || !std::isfinite(image.radius)) return std::nullopt;
    return image;
  }

  /// The least and the largest weight in a ball.
  std::pair<double, double> weights_in(const SolidBall& ball) const {
    const PlaceOf<Slope> center = sloped(ball.center);
    const Slope weight = weight_of(motion_.back, center, 0.5 * square(center));
    const double change = length(weight.gradient) * ball.radius, bend = motion_.pull * ball.radius * ball.radius;
    const double least = std::max(least_weight, weight.value - change + bend);
    return {least, std::max(least, weight.value + change + bend)};
  }

  SharedField field_;
  Motion motion_;
};

}  // namespace

std::optional<SharedField> moved_field(SharedField field, const Versor& versor) {
  const std::optional<ConformalMap> back = map_of(reverse(versor)), forth = map_of(versor);
  if (!back || !forth) return std::nullopt;
  MovedField::Motion motion{*back, 0.5 * back->infinity.no, {}, 1};
  std::optional<Reach> reach;
  if (field->reach()) {
    const auto& [ball, outside] = *field->reach();
    const double radius = std::max(ball.radius, 1e-9);
    const Vector& c = ball.center;
    const double power = 0.5 * (squared_length(c) - radius * radius);
    const auto image = [&](auto member) {
      return (forth->origin.*member + c.x * (forth->x.*member) + c.y * (forth->y.*member) + c.z * (forth->z.*member) +
              power * (forth->infinity.*member)) /
             radius;
    };
    const Sphere sphere{image(&Sphere::no), image(&Sphere::e), image(&Sphere::ni)};
    if (std::isfinite(sphere.no) && is_finite(sphere.e) && std::isfinite(sphere.ni)) {
      motion.reach = CarriedBall{sphere};
      motion.outside = outside;
      // The image is a ball again unless what goes to infinity is in the ball.
      const SolidBall carried{sphere.e / sphere.no, 1 / sphere.no};
      if (sphere.no > 0 && is_finite(carried.center) && std::isfinite(carried.radius)) {
        reach = Reach{carried, outside};
      }
    }
  }
  return std::make_shared<MovedField>(std::move(field), motion, reach);
}

}  // namespace dini

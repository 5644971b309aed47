#include "geometry/field_shapes.h"

#include <algorithm>
#include <string>

#include "geometry/bounding_box.h"
#include "geometry/field_blend.h"

namespace dini {

namespace {

Reach around(const Vector& center, double radius) { return {{center, radius}, 1}; }

class SphereField : public FormulaField<SphereField> {
 public:
  SphereField(const Vector& center, double radius)
      : FormulaField({1, 1, sizeof(*this)}, around(center, radius)), center_(center), radius_(radius) {}

  template <class Number>
  Number at(const PlaceOf<Number>& place) const {
    return root(square(place - center_)) - radius_;
  }
  std::string formula() const override { return "sphere"; }

 private:
  Vector center_;
  double radius_;
};

class PlaneField : public FormulaField<PlaneField> {
 public:
  PlaneField(const Vector& normal, double distance)
      : FormulaField({1, 1, sizeof(*this)}, std::nullopt), normal_(normal), distance_(distance) {}

  template <class Number>
  Number at(const PlaceOf<Number>& place) const {
    return dot(normal_, place) - distance_;
  }
  std::string formula() const override { return "plane"; }

 private:
  Vector normal_;
  double distance_;
};

class RingField : public FormulaField<RingField> {
 public:
  RingField(const Vector& center, const Vector& normal, double radius, double thickness)
      : FormulaField({1, 1, sizeof(*this)}, around(center, radius + thickness)),
        center_(center),
        normal_(normal),
        across_(any_perpendicular(normal)),
        along_(cross(normal_, across_)),
        radius_(radius),
        thickness_(thickness) {}

  template <class Number>
  Number at(const PlaceOf<Number>& place) const {
    const PlaceOf<Number> y = place - center_;
    const Number u = dot(across_, y), v = dot(along_, y), above = dot(normal_, y);
    const Number out = root(u * u + v * v) - radius_;
    return root(out * out + above * above) - thickness_;
  }
  std::string formula() const override { return "ring"; }

 private:
  Vector center_, normal_, across_, along_;
  double radius_, thickness_;
};

class RodField : public FormulaField<RodField> {
 public:
  RodField(const Vector& point, const Vector& direction, double thickness)
      : FormulaField({1, 1, sizeof(*this)}, std::nullopt),
        point_(point),
        across_(any_perpendicular(direction)),
        along_(cross(direction, across_)),
        thickness_(thickness) {}

  template <class Number>
  Number at(const PlaceOf<Number>& place) const {
    const PlaceOf<Number> y = place - point_;
    const Number u = dot(across_, y), v = dot(along_, y);
    return root(u * u + v * v) - thickness_;
  }
  std::string formula() const override { return "rod"; }

 private:
  Vector point_, across_, along_;
  double thickness_;
};

class BoxField : public FormulaField<BoxField> {
 public:
  BoxField(const Vector& low, const Vector& high)
      : FormulaField({1, 1, sizeof(*this)}, std::nullopt), low_(low), high_(high) {}

  template <class Number>
  Number at(const PlaceOf<Number>& place) const {
    Number largest = place.x - high_.x;
    for (const Number& beyond :
         {-(place.x - low_.x), place.y - high_.y, -(place.y - low_.y), place.z - high_.z, -(place.z - low_.z)}) {
      if (value_of(beyond) > value_of(largest)) largest = beyond;
    }
    return largest;
  }
  std::string formula() const override { return "box"; }

 private:
  Vector low_, high_;
};

SolidBall ball_around(const Column<Point>& points, const Cancel& cancel) {
  CancelEvery steps(cancel);
  BoundingBox bounds;
  for (std::size_t i = 0; i < points.size() && !steps.stopped(); ++i) bounds.add(to_vector(points[i]));
  SolidBall ball{0.5 * bounds.low + 0.5 * bounds.high, 0};
  for (std::size_t i = 0; i < points.size() && !steps.stopped(); ++i) {
    ball.radius = std::max(ball.radius, length(to_vector(points[i]) - ball.center));
  }
  return ball;
}

/// Distances come from all points one after another: a narrowed field has few.
class BallsField : public ScalarField {
 public:
  BallsField(Column<Point> centers, double radius, double blend, SolidBall around)
      : ScalarField({1, 1, sizeof(*this) + centers.bytes()}, Reach{{around.center, around.radius + radius + blend}, 1}),
        centers_(std::move(centers)),
        around_(around),
        radius_(radius),
        blend_(blend) {}

  void values(const Places& at, double* out) const override {
    std::vector<double> distances(centers_.size());
    for (std::size_t i = 0; i < at.count; ++i) {
      measure({at.x[i], at.y[i], at.z[i]}, distances);
      out[i] = rounded_minimum(distances, blend_) - radius_;
    }
  }

  Slope slope(const Vector& at) const override {
    std::vector<double> distances(centers_.size()), shares(centers_.size());
    measure(at, distances);
    Slope sum{rounded_minimum(distances, blend_, &shares) - radius_, {}};
    for (std::size_t k = 0; k < shares.size(); ++k) {
      if (shares[k] == 0 || distances[k] == 0) continue;
      sum.gradient = sum.gradient + (shares[k] / distances[k]) * (at - to_vector(centers_[k]));
    }
    return sum;
  }

  Narrowed narrowed(const SolidBall& ball, const SharedField& self) const override {
    std::vector<double> distances(centers_.size());
    measure(ball.center, distances);
    const double middle = rounded_minimum(distances, blend_) - radius_;
    const Interval values{middle - ball.radius, middle + ball.radius};
    const double nearest = *std::min_element(distances.begin(), distances.end());
    const double needed = nearest + 2 * ball.radius + blend_ + narrowing_slack * ball.radius;
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < distances.size(); ++k) {
      if (!(distances[k] >= needed)) kept.push_back(k);
    }
    if (kept.size() == centers_.size()) return {values, self};
    Column<Point> few(kept.size());
    for (std::size_t k = 0; k < kept.size(); ++k) few.set(k, centers_[kept[k]]);
    return {values, std::make_shared<BallsField>(std::move(few), radius_, blend_, around_)};
  }

  std::string formula() const override { return "balls(" + std::to_string(centers_.size()) + ")"; }

 private:
  void measure(const Vector& place, std::vector<double>& distances) const {
    const double *x = centers_.component(0), *y = centers_.component(1), *z = centers_.component(2);
    for (std::size_t k = 0; k < distances.size(); ++k) {
      const double dx = place.x - x[k], dy = place.y - y[k], dz = place.z - z[k];
      distances[k] = std::sqrt(dx * dx + dy * dy + dz * dz);
    }
  }

  Column<Point> centers_;
  SolidBall around_;  ///< of all that there were before any were left out
  double radius_, blend_;
};

}  // namespace

SharedField sphere_field(const Vector& center, double radius) { return std::make_shared<SphereField>(center, radius); }

SharedField plane_field(const Vector& normal, double distance) {
  return std::make_shared<PlaneField>(normal, distance);
}

SharedField ring_field(const Vector& center, const Vector& normal, double radius, double thickness) {
  return std::make_shared<RingField>(center, normal, radius, thickness);
}

SharedField rod_field(const Vector& point, const Vector& direction, double thickness) {
  return std::make_shared<RodField>(point, direction, thickness);
}

SharedField balls_field(Column<Point> centers, double radius, double blend, const Cancel& cancel) {
  const SolidBall around = ball_around(centers, cancel);
  return std::make_shared<BallsField>(std::move(centers), radius, blend, around);
}

SharedField box_field(const Vector& low, const Vector& high) { return std::make_shared<BoxField>(low, high); }

}  // namespace dini

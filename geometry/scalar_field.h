#pragma once

// Scalar fields: a number at every place of space, below zero inside a solid, zero on its surface, and near the surface
// the distance from it, in meters. A field is an immutable tree of shapes and of what is done with them; whoever makes
// one of another shares it.
//
// What a mesher needs of a field beside its values is a bound of them over a ball (SolidBall): conformal maps take
// balls to balls, so a bound goes through a boost without getting wider. With it comes the field that is left of it in
// that ball: of a union of a thousand shapes the few that decide there.

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/slope.h"

namespace dini {

class ScalarField;
using SharedField = std::shared_ptr<const ScalarField>;

/// Component arrays of places.
struct Places {
  const double* x;
  const double* y;
  const double* z;
  std::size_t count;
};

struct SolidBall {
  Vector center;
  double radius = 0;
};

/// Between which numbers a field stays. Unknown ends are infinite.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// What is known of a field in a ball: the bounds of its values, and a field that has the same values there to the last
/// bit and is quicker to compute.
struct Narrowed {
  Interval values;
  SharedField field;
};

/// A ball that holds the whole surface, and on which side the solid is: outside of it the field has one sign, and is at
/// least as far from zero as the ball is away.
struct Reach {
  SolidBall ball;
  double outside = 1;  ///< 1 where the field is positive outside, -1 where the solid is all the rest of space
};

/// How large a tree is; a branch that is shared counts as often as it is met.
struct FieldSize {
  std::size_t operations = 1;
  std::size_t depth = 1;
  std::size_t bytes = 0;
};

class ScalarField {
 public:
  /// Larger trees are refused where they are made: what follows a tree goes down it by recursion, and visits all of it.
  static constexpr std::size_t most_operations = 4096, most_depth = 128;

  virtual ~ScalarField() = default;
  ScalarField(const ScalarField&) = delete;
  ScalarField& operator=(const ScalarField&) = delete;

  /// The value at each place. Never NaN for finite places below 1e9.
  virtual void values(const Places& at, double* out) const = 0;
  /// The value at one place with the gradient.
  virtual Slope slope(const Vector& at) const = 0;
  /// What is known of the field in a ball. `self` is this field.
  virtual Narrowed narrowed(const SolidBall& ball, const SharedField& self) const = 0;
  /// Written as a formula: "union(sphere, moved(ring))".
  virtual std::string formula() const = 0;

  const FieldSize& size() const { return size_; }
  /// Nothing for a surface that may be without bounds.
  const std::optional<Reach>& reach() const { return reach_; }

 protected:
  ScalarField(FieldSize size, std::optional<Reach> reach) : size_(size), reach_(reach) {}

 private:
  FieldSize size_;
  std::optional<Reach> reach_;
};

/// A field whose value at a place is a formula of its coordinates: `Formula` has `Number at(PlaceOf<Number>) const`.
template <class Formula>
class FormulaField : public ScalarField {
 public:
  void values(const Places& at, double* out) const override {
    for (std::size_t i = 0; i < at.count; ++i) out[i] = formula_at(PlaceOf<double>{at.x[i], at.y[i], at.z[i]});
  }
  Slope slope(const Vector& at) const override { return formula_at(sloped(at)); }

  /// The value at the center, give or take the radius: the formula is that of a distance.
  Narrowed narrowed(const SolidBall& ball, const SharedField& self) const override {
    const double middle = formula_at(PlaceOf<double>{ball.center.x, ball.center.y, ball.center.z});
    return {{middle - ball.radius, middle + ball.radius}, self};
  }

 protected:
  using ScalarField::ScalarField;

 private:
  template <class Number>
  Number formula_at(const PlaceOf<Number>& place) const {
    return static_cast<const Formula*>(this)->at(place);
  }
};

/// The size of a tree over `branches`.
FieldSize size_over(const std::vector<SharedField>& branches, std::size_t own_bytes);

/// Whether a tree is within the limits: one sentence that says what is too large, or nothing.
std::optional<std::string> too_large(const FieldSize& size);

/// The value at one place.
double value_at(const ScalarField& field, const Vector& place);

}  // namespace dini

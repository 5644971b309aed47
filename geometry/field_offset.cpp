#include "geometry/field_offset.h"

#include <algorithm>
#include <cmath>

namespace dini {

namespace {

std::optional<Reach> grown(std::optional<Reach> reach, double distance) {
  if (reach) reach->ball.radius += distance;
  return reach;
}

class OffsetField : public ScalarField {
 public:
  OffsetField(SharedField field, double distance, std::optional<Reach> reach)
      : ScalarField(size_over({field}, sizeof(*this)), reach), field_(std::move(field)), distance_(distance) {}

  void values(const Places& at, double* out) const override {
    field_->values(at, out);
    for (std::size_t i = 0; i < at.count; ++i) out[i] -= distance_;
  }
  Slope slope(const Vector& at) const override { return field_->slope(at) - distance_; }

  Narrowed narrowed(const SolidBall& ball, const SharedField& self) const override {
    Narrowed one = field_->narrowed(ball, field_);
    const Interval values{one.values.low - distance_, one.values.high - distance_};
    if (one.field == field_) return {values, self};
    return {values, std::make_shared<OffsetField>(std::move(one.field), distance_, reach())};
  }
  std::string formula() const override { return "offset(" + field_->formula() + ")"; }

 private:
  SharedField field_;
  double distance_;
};

/// |f - middle| - half.
class ShellField : public ScalarField {
 public:
  ShellField(SharedField field, double middle, double half, std::optional<Reach> reach)
      : ScalarField(size_over({field}, sizeof(*this)), reach), field_(std::move(field)), middle_(middle), half_(half) {}

  void values(const Places& at, double* out) const override {
    field_->values(at, out);
    for (std::size_t i = 0; i < at.count; ++i) out[i] = std::abs(out[i] - middle_) - half_;
  }
  Slope slope(const Vector& at) const override { return magnitude(field_->slope(at) - middle_) - half_; }

  Narrowed narrowed(const SolidBall& ball, const SharedField& self) const override {
    Narrowed one = field_->narrowed(ball, field_);
    const double low = one.values.low - middle_, high = one.values.high - middle_;
    const double nearest = low > 0 ? low : high < 0 ? -high : 0;
    const Interval values{nearest - half_, std::max(-low, high) - half_};
    if (one.field == field_) return {values, self};
    return {values, std::make_shared<ShellField>(std::move(one.field), middle_, half_, reach())};
  }
  std::string formula() const override { return "shell(" + field_->formula() + ")"; }

 private:
  SharedField field_;
  double middle_, half_;
};

}  // namespace

SharedField offset_field(SharedField field, double distance) {
  const std::optional<Reach> reach = grown(field->reach(), std::abs(distance));
  return std::make_shared<OffsetField>(std::move(field), distance, reach);
}

SharedField shell_field(SharedField field, double thickness, double inside) {
  const double half = 0.5 * thickness, middle = half - inside;
  std::optional<Reach> reach = grown(field->reach(), std::abs(middle) + half);
  if (reach) reach->outside = 1;
  return std::make_shared<ShellField>(std::move(field), middle, half, reach);
}

}  // namespace dini

#include "geometry/field_blend.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/bounding_box.h"

namespace dini {

double rounded_minimum(std::span<const double> numbers, double blend, std::vector<double>* shares) {
  std::size_t least = 0;
  for (std::size_t k = 1; k < numbers.size(); ++k) {
    if (numbers[k] < numbers[least]) least = k;
  }
  const double lowest = numbers[least];
  if (shares != nullptr) {
    std::fill(shares->begin(), shares->end(), 0.0);
    (*shares)[least] = 1;
  }
  if (blend == 0 || !std::isfinite(lowest)) return lowest;
  std::vector<std::pair<double, std::size_t>> near;  // how far below v = lowest each begins to count
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const double begin = numbers[k] - lowest - blend;
    if (begin < 0) near.emplace_back(begin, k);
  }
  if (near.size() == 1) return lowest;
  std::sort(near.begin(), near.end());
  double sum = near[0].first, squares = sum * sum, v = 0;
  std::size_t count = 1;
  while (count < near.size() && near[count].first < v) {
    sum += near[count].first;
    squares += near[count].first * near[count].first;
    ++count;
    const auto n = static_cast<double>(count);
    v = (sum + std::sqrt(std::max(0.0, sum * sum - n * (squares - blend * blend)))) / n;
  }
  if (shares != nullptr) {
    const double all = static_cast<double>(count) * v - sum;
    (*shares)[least] = 0;
    for (std::size_t k = 0; k < count; ++k) (*shares)[near[k].second] = (v - near[k].first) / all;
  }
  return lowest + v;
}

SolidBall ball_around(const std::vector<SolidBall>& balls) {
  BoundingBox bounds;
  for (const SolidBall& ball : balls) {
    const Vector corner{ball.radius, ball.radius, ball.radius};
    bounds.add(ball.center - corner);
    bounds.add(ball.center + corner);
  }
  SolidBall around{0.5 * bounds.low + 0.5 * bounds.high, 0};
  for (const SolidBall& ball : balls) {
    around.radius = std::max(around.radius, length(ball.center - around.center) + ball.radius);
  }
  return around;
}

namespace {

/// Where the surface of a union (`side` 1) or of an intersection (-1) can be. One solid that is bounded bounds an
/// intersection, whatever the others are.
std::optional<Reach> reach_of_blend(const std::vector<SharedField>& fields, double side, double blend) {
  std::optional<Reach> least;
  std::vector<SolidBall> balls;
  for (const SharedField& field : fields) {
    const std::optional<Reach>& reach = field->reach();
    if (!reach) continue;
    balls.push_back(reach->ball);
    if (reach->outside != -side) continue;
    if (!least || reach->ball.radius < least->ball.radius) least = reach;
  }
  if (least) return least;
  if (balls.size() < fields.size()) return std::nullopt;
  SolidBall around = ball_around(balls);
  around.radius += blend;
  return Reach{around, side};
}

class BlendField : public ScalarField {
 public:
  BlendField(std::vector<SharedField> fields, double side, double blend, std::optional<Reach> reach)
      : ScalarField(size_over(fields, sizeof(*this) + fields.size() * sizeof(SharedField)), reach),
        fields_(std::move(fields)),
        side_(side),
        blend_(blend) {}

  void values(const Places& at, double* out) const override {
    const std::size_t count = fields_.size();
    std::vector<double> each(count * at.count);
    for (std::size_t k = 0; k < count; ++k) fields_[k]->values(at, each.data() + k * at.count);
    if (blend_ == 0) {
      for (std::size_t i = 0; i < at.count; ++i) out[i] = side_ * each[i];
      for (std::size_t k = 1; k < count; ++k) {
        const double* other = each.data() + k * at.count;
        for (std::size_t i = 0; i < at.count; ++i) out[i] = std::min(out[i], side_ * other[i]);
      }
      for (std::size_t i = 0; i < at.count; ++i) out[i] = side_ * out[i];
      return;
    }
    std::vector<double> numbers(count);
    for (std::size_t i = 0; i < at.count; ++i) {
      for (std::size_t k = 0; k < count; ++k) numbers[k] = side_ * each[k * at.count + i];
      out[i] = side_ * rounded_minimum(numbers, blend_);
    }
  }

  Slope slope(const Vector& at) const override {
    std::vector<Slope> each;
    std::vector<double> numbers, shares(fields_.size());
    for (const SharedField& field : fields_) {
      each.push_back(field->slope(at));
      numbers.push_back(side_ * each.back().value);
    }
    Slope sum{side_ * rounded_minimum(numbers, blend_, &shares), {}};
    for (std::size_t k = 0; k < each.size(); ++k) {
      if (shares[k] != 0) sum.gradient = sum.gradient + shares[k] * each[k].gradient;
    }
    return sum;
  }

  Narrowed narrowed(const SolidBall& ball, const SharedField& self) const override {
    std::vector<SharedField> all, kept;
    std::vector<double> lows, highs;
    bool changed = false;
    for (const SharedField& field : fields_) {
      Narrowed one = field->narrowed(ball, field);
      changed = changed || one.field != field;
      lows.push_back(side_ > 0 ? one.values.low : -one.values.high);
      highs.push_back(side_ > 0 ? one.values.high : -one.values.low);
      all.push_back(std::move(one.field));
    }
    const double low = rounded_minimum(lows, blend_), high = rounded_minimum(highs, blend_);
    const double needed = *std::min_element(highs.begin(), highs.end()) + blend_ + narrowing_slack * ball.radius;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (!(lows[k] >= needed)) kept.push_back(std::move(all[k]));
    }
    const Interval values = side_ > 0 ? Interval{low, high} : Interval{-high, -low};
    if (kept.size() == 1) return {values, std::move(kept.front())};
    if (!changed && kept.size() == fields_.size()) return {values, self};
    return {values, std::make_shared<BlendField>(std::move(kept), side_, blend_, reach())};
  }

  std::string formula() const override {
    std::string text = side_ > 0 ? "union(" : "intersection(";
    for (std::size_t k = 0; k < fields_.size(); ++k) text += (k > 0 ? ", " : "") + fields_[k]->formula();
    return text + ")";
  }

 private:
  std::vector<SharedField> fields_;
  double side_;
  double blend_;
};

class ComplementField : public ScalarField {
 public:
  ComplementField(SharedField field, std::optional<Reach> reach)
      : ScalarField(size_over({field}, sizeof(*this)), reach), field_(std::move(field)) {}

  void values(const Places& at, double* out) const override {
    field_->values(at, out);
    for (std::size_t i = 0; i < at.count; ++i) out[i] = -out[i];
  }
  Slope slope(const Vector& at) const override { return -field_->slope(at); }

  Narrowed narrowed(const SolidBall& ball, const SharedField& self) const override {
    Narrowed one = field_->narrowed(ball, field_);
    const Interval values{-one.values.high, -one.values.low};
    if (one.field == field_) return {values, self};
    return {values, std::make_shared<ComplementField>(std::move(one.field), reach())};
  }
  std::string formula() const override { return "complement(" + field_->formula() + ")"; }

 private:
  SharedField field_;
};

SharedField blended(std::vector<SharedField> fields, double side, double blend) {
  if (fields.size() == 1) return std::move(fields.front());
  const std::optional<Reach> reach = reach_of_blend(fields, side, blend);
  return std::make_shared<BlendField>(std::move(fields), side, blend, reach);
}

}  // namespace

SharedField union_field(std::vector<SharedField> fields, double blend) { return blended(std::move(fields), 1, blend); }

SharedField intersection_field(std::vector<SharedField> fields, double blend) {
  return blended(std::move(fields), -1, blend);
}

SharedField complement_field(SharedField field) {
  std::optional<Reach> reach = field->reach();
  if (reach) reach->outside = -reach->outside;
  return std::make_shared<ComplementField>(std::move(field), reach);
}

}  // namespace dini

#include "gltf/quantization.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dini {
namespace {

// Below this a cell size would leave the normal floats, and the number of cells per meter would overflow.
constexpr float smallest_range = 1e-30f;

float largest_extent(const FloatBox& box) {
  float result = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) result = std::max(result, box.maximum[axis] - box.minimum[axis]);
  return result;
}

}  // namespace

void FloatBox::include(const std::array<float, 3>& point) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    minimum[axis] = std::min(minimum[axis], point[axis]);
    maximum[axis] = std::max(maximum[axis], point[axis]);
  }
}

void FloatBox::include(const FloatBox& box) {
  if (box.empty()) return;
  include(box.minimum);
  include(box.maximum);
}

float FloatBox::largest() const {
  if (empty()) return 0;
  float result = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result = std::max({result, std::abs(minimum[axis]), std::abs(maximum[axis])});
  }
  return result;
}

QuantizationGrid::QuantizationGrid(const FloatBox& box, int bits) : bits_(bits) {
  if (box.empty()) return;
  box_ = box;
  if (largest_extent(box_) == 0) return;
  if (largest_extent(box_) < smallest_range) box_.maximum[0] = box_.minimum[0] + smallest_range;
  range_ = largest_extent(box_);
}

float QuantizationGrid::cells() const { return static_cast<float>((1u << bits_) - 1u); }

float QuantizationGrid::decoded(std::size_t axis, float value) const {
  const float cells_per_meter = cells() / range_;
  const float meters_per_cell = range_ / cells();
  const float origin = box_.minimum[axis];
  const float cell = std::floor((value - origin) * cells_per_meter + 0.5f);
  return cell * meters_per_cell + origin;
}

FloatBox QuantizationGrid::decoded(const FloatBox& box) const {
  FloatBox result;
  if (box.empty()) return result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.minimum[axis] = decoded(axis, box.minimum[axis]);
    result.maximum[axis] = decoded(axis, box.maximum[axis]);
  }
  return result;
}

double QuantizationGrid::position_error() const {
  const double largest = static_cast<double>(box_.largest());
  if (largest_extent(box_) == 0) return float_rounding * largest;
  // Six roundings relative to the range (offset, two in cells, the half, two back) and two relative to the coordinate
  // (to float, adding the origin); 8 and 2.5 leave room for the products of roundings.
  const double range = static_cast<double>(range_);
  return 0.5 * range / static_cast<double>(cells()) + float_rounding * (8 * range + 2.5 * largest);
}

double octahedral_error(int bits) {
  // Half a cell in both octahedral coordinates is stretched most at the middle of a face, by 3 sqrt(2); the factor
  // covers the second order.
  return 1.05 * 3 * std::sqrt(2.0) / (std::ldexp(1.0, bits) - 2);
}

}  // namespace dini

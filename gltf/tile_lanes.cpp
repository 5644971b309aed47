#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gltf/tile_lanes.cpp"
// clang-format off: this compiles the file once per instruction set, so it comes before all other headers
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// clang-format on

#include <algorithm>

#include "gltf/tile_lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace dini::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using Floats = hn::Rebind<float, Doubles>;
using Places = hn::Rebind<std::int64_t, Doubles>;
using Numbers = hn::Rebind<std::uint32_t, Doubles>;

HWY_INLINE hn::Vec<Places> places_of(const std::uint32_t* vertices) {
  return hn::BitCast(Places(), hn::PromoteTo(hn::Rebind<std::uint64_t, Doubles>(), hn::LoadU(Numbers(), vertices)));
}

tile_lanes::IndexRange range_lanes(const std::uint32_t* indices, std::size_t count) {
  const hn::ScalableTag<std::uint32_t> d;
  const std::size_t lanes = hn::Lanes(d);
  tile_lanes::IndexRange range = {0xffffffff, 0};
  std::size_t i = 0;
  if (count >= lanes) {
    auto least = hn::LoadU(d, indices), greatest = least;
    for (; i + lanes <= count; i += lanes) {
      const auto some = hn::LoadU(d, indices + i);
      least = hn::Min(least, some);
      greatest = hn::Max(greatest, some);
    }
    HWY_ALIGN std::uint32_t each[hn::MaxLanes(d)];
    hn::Store(least, d, each);
    range.least = *std::min_element(each, each + lanes);
    hn::Store(greatest, d, each);
    range.greatest = *std::max_element(each, each + lanes);
  }
  for (; i < count; ++i) {
    range.least = std::min(range.least, indices[i]);
    range.greatest = std::max(range.greatest, indices[i]);
  }
  return range;
}

bool values_lanes(const double* values, std::size_t stride, const std::uint32_t* vertices, std::size_t count,
                  double limit, float* out, tile_lanes::Bounds& bounds) {
  const Doubles d;
  const Floats f;
  const std::size_t lanes = hn::Lanes(d);
  const auto reach = hn::Set(d, limit);
  auto within = hn::Eq(hn::Zero(d), hn::Zero(d));
  auto low = hn::Set(f, bounds.minimum), high = hn::Set(f, bounds.maximum);
  HWY_ALIGN std::uint32_t last[hn::MaxLanes(d)];
  HWY_ALIGN float rounded[hn::MaxLanes(d)];
  for (std::size_t i = 0; i < count; i += lanes) {
    const bool whole = i + lanes <= count;
    // What is missing of the last ones is filled with the first of them.
    for (std::size_t k = 0; k < lanes && !whole; ++k) last[k] = vertices[i + k < count ? i + k : i];
    auto places = places_of(whole ? vertices + i : last);
    if (stride == 2) places = hn::Add(places, places);
    const auto value = hn::GatherIndex(d, values, places);
    within = hn::And(within, hn::Lt(hn::Abs(value), reach));
    const auto single = hn::DemoteTo(f, value);
    low = hn::Min(low, single);
    high = hn::Max(high, single);
    if (whole) {
      hn::StoreU(single, f, out + i);
    } else {
      hn::Store(single, f, rounded);
      std::copy(rounded, rounded + (count - i), out + i);
    }
  }
  hn::Store(low, f, rounded);
  bounds.minimum = *std::min_element(rounded, rounded + lanes) + 0.0f;
  hn::Store(high, f, rounded);
  bounds.maximum = *std::max_element(rounded, rounded + lanes) + 0.0f;
  return hn::AllTrue(d, within);
}

bool vectors_lanes(const std::array<const double*, 3>& components, const std::uint32_t* vertices, std::size_t count,
                   double least, double greatest, const std::array<float*, 3>& out) {
  const Doubles d;
  const Floats f;
  const std::size_t lanes = hn::Lanes(d);
  const auto lower = hn::Set(d, least), upper = hn::Set(d, greatest);
  auto usual = hn::Eq(hn::Zero(d), hn::Zero(d));
  HWY_ALIGN std::uint32_t last[hn::MaxLanes(d)];
  HWY_ALIGN float rounded[hn::MaxLanes(d)];
  for (std::size_t i = 0; i < count; i += lanes) {
    const bool whole = i + lanes <= count;
    for (std::size_t k = 0; k < lanes && !whole; ++k) last[k] = vertices[i + k < count ? i + k : i];
    const auto places = places_of(whole ? vertices + i : last);
    auto size = hn::Zero(d);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto value = hn::GatherIndex(d, components[k], places);
      size = hn::Add(size, hn::Abs(value));
      const auto single = hn::DemoteTo(f, value);
      if (whole) {
        hn::StoreU(single, f, out[k] + i);
      } else {
        hn::Store(single, f, rounded);
        std::copy(rounded, rounded + (count - i), out[k] + i);
      }
    }
    usual = hn::And(usual, hn::And(hn::Gt(size, lower), hn::Lt(size, upper)));
  }
  return hn::AllTrue(d, usual);
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dini {
HWY_EXPORT(range_lanes);
HWY_EXPORT(values_lanes);
HWY_EXPORT(vectors_lanes);

namespace tile_lanes {

IndexRange range_of(const std::uint32_t* indices, std::size_t count) {
  return HWY_DYNAMIC_DISPATCH(range_lanes)(indices, count);
}

bool round_values(const double* values, std::size_t stride, const std::uint32_t* vertices, std::size_t count,
                  double limit, float* out, Bounds& bounds) {
  return HWY_DYNAMIC_DISPATCH(values_lanes)(values, stride, vertices, count, limit, out, bounds);
}

bool round_vectors(const std::array<const double*, 3>& components, const std::uint32_t* vertices, std::size_t count,
                   double least, double greatest, const std::array<float*, 3>& out) {
  return HWY_DYNAMIC_DISPATCH(vectors_lanes)(components, vertices, count, least, greatest, out);
}

}  // namespace tile_lanes
}  // namespace dini
#endif

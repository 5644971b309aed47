#include "draco/attribute_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "draco/attribute_kernels.cpp"
// clang-format off: this compiles the file once per instruction set, so it comes before all other headers
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// clang-format on

#include <cstring>

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace dini::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using kernels::Row;
using kernels::Steps;

// A row in one vector, or lane by lane where the processor has none.
using RowTag = hn::CappedTag<std::int32_t, 4>;
using FloatRowTag = hn::CappedTag<float, 4>;

template <std::size_t columns>
void quantize_lanes(std::span<const std::array<float, columns>> values, const Steps& steps, Row* rows) {
  static_assert(columns == 2 || columns == 3);
  constexpr Row used_lanes = {-1, -1, columns > 2 ? -1 : 0, 0};
  const FloatRowTag floats;
  const RowTag d;
  const auto per_unit = hn::Set(floats, steps.per_unit);
  const auto half = hn::Set(floats, 0.5f);
  const auto quantize_row = [&](const float* value, Row& row) HWY_ATTR {
    for (std::size_t lane = 0; lane < row.size(); lane += hn::Lanes(d)) {
      const auto used = hn::LoadU(d, used_lanes.data() + lane);
      const auto offset = hn::LoadU(floats, value + lane) - hn::LoadU(floats, steps.origin.data() + lane);
      hn::StoreU(hn::And(hn::ConvertTo(d, offset * per_unit + half), used), d, row.data() + lane);
    }
  };
  // Reads a little of the next value, so the last one is copied to where there is room.
  for (std::size_t i = 0; i + 1 < values.size(); ++i) quantize_row(values[i].data(), rows[i]);
  std::array<float, 4> last = steps.origin;
  std::memcpy(last.data(), values.back().data(), sizeof values.back());
  quantize_row(last.data(), rows[values.size() - 1]);
}

void quantize_two(std::span<const std::array<float, 2>> values, const Steps& steps, Row* rows) {
  quantize_lanes(values, steps, rows);
}
void quantize_three(std::span<const std::array<float, 3>> values, const Steps& steps, Row* rows) {
  quantize_lanes(values, steps, rows);
}

void predict_lanes(const Row* rows, const VertexOrder& order, std::int32_t minimum, std::int32_t maximum,
                   std::uint32_t* left) {
  const RowTag d;
  const std::int32_t count = 1 + maximum - minimum;
  const std::int32_t highest = (count - 1) / 2;
  const auto lowest_lanes = hn::Set(d, highest + 1 - count);
  const auto highest_lanes = hn::Set(d, highest);
  const auto count_lanes = hn::Set(d, count);
  const auto least = hn::Set(d, minimum);
  const auto most = hn::Set(d, maximum);
  const auto store = [&](std::size_t i, std::size_t lane, auto predicted) HWY_ATTR {
    auto rest = hn::LoadU(d, rows[order.vertices[i]].data() + lane) - hn::Min(hn::Max(predicted, least), most);
    rest = rest - hn::IfThenElseZero(rest > highest_lanes, count_lanes);
    rest = rest + hn::IfThenElseZero(rest < lowest_lanes, count_lanes);
    const auto without_sign = hn::ShiftLeft<1>(rest) ^ hn::ShiftRight<31>(rest);
    hn::StoreU(without_sign, d, reinterpret_cast<std::int32_t*>(left) + 4 * i + lane);
  };
  for (std::size_t lane = 0; lane < Row().size(); lane += hn::Lanes(d)) store(0, lane, hn::Zero(d));
  for (std::size_t i = 1; i < order.vertices.size(); ++i) {
    const auto& [after, before, across] = order.parallelograms[i];
    const Row &a = rows[after], &b = rows[before], &c = rows[across];
    for (std::size_t lane = 0; lane < Row().size(); lane += hn::Lanes(d)) {
      store(i, lane, hn::LoadU(d, &a[lane]) + hn::LoadU(d, &b[lane]) - hn::LoadU(d, &c[lane]));
    }
  }
}

using Doubles = hn::ScalableTag<double>;
using Halves = hn::Rebind<std::int32_t, Doubles>;
using Singles = hn::Rebind<float, Doubles>;

/// Points of the square by coordinates.
template <class V>
struct PointLanes {
  V s, t;
};

// Octahedron::point, whole numbers held in doubles.
template <class V>
HWY_INLINE PointLanes<V> point_lanes(V x, V y, V z, double center) {
  const Doubles d;
  const auto zero = hn::Zero(d), middle = hn::Set(d, center), side = hn::Set(d, 2 * center), half = hn::Set(d, 0.5);
  const auto length = hn::Abs(x) + hn::Abs(y) + hn::Abs(z);
  const auto is_direction = length > hn::Set(d, Octahedron::shortest_direction);
  const auto scale = hn::Set(d, 1.0) / hn::IfThenElse(is_direction, length, hn::Set(d, 1.0));
  const auto first = hn::IfThenElse(is_direction, hn::Floor(x * scale * middle + half), middle);
  const auto second = hn::IfThenElseZero(is_direction, hn::Floor(y * scale * middle + half));
  const auto rest = middle - hn::Abs(first) - hn::Abs(second);
  const auto excess = hn::Min(rest, zero);
  const auto kept = hn::IfThenElse(second > zero, second + excess, second - excess);
  const auto size = hn::Max(rest, zero);
  const auto third = hn::IfThenElse(z < zero, zero - size, size);
  const auto near = first >= zero;
  const auto s = hn::IfThenElse(near, kept + middle, hn::IfThenElse(kept < zero, size, side - size));
  const auto t =
      hn::IfThenElse(near, third + middle, hn::IfThenElse(third < zero, hn::Abs(kept), side - hn::Abs(kept)));
  const auto s_first = s == zero, s_last = s == side, t_first = t == zero, t_last = t == side;
  const auto is_corner = hn::And(hn::Or(s_first, s_last), hn::Or(t_first, t_last));
  const auto mirror_t = hn::Or(hn::And(s_first, t > middle), hn::And(s_last, t < middle));
  const auto mirror_s = hn::Or(hn::And(t_last, s < middle), hn::And(t_first, s > middle));
  return {hn::IfThenElse(is_corner, side, hn::IfThenElse(mirror_s, side - s, s)),
          hn::IfThenElse(is_corner, side, hn::IfThenElse(mirror_t, side - t, t))};
}

void points_lanes(const Octahedron& octahedron, const float* const (&directions)[3], std::size_t count, std::int32_t* s,
                  std::int32_t* t) {
  const Doubles d;
  const Halves whole;
  const Singles singles;
  const auto coordinate = [&](std::size_t axis, std::size_t i)
                              HWY_ATTR { return hn::PromoteTo(d, hn::LoadU(singles, directions[axis] + i)); };
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
    const auto point = point_lanes(coordinate(0, i), coordinate(1, i), coordinate(2, i), octahedron.center());
    hn::StoreU(hn::DemoteTo(whole, point.s), whole, s + i);
    hn::StoreU(hn::DemoteTo(whole, point.t), whole, t + i);
  }
  for (; i < count; ++i) {
    const SquarePoint point = octahedron.point({directions[0][i], directions[1][i], directions[2][i]});
    s[i] = point.s;
    t[i] = point.t;
  }
}

using Integers = hn::ScalableTag<std::int32_t>;
using IntegerLanes = hn::Vec<Integers>;

HWY_INLINE PointLanes<IntegerLanes> mirrored_lanes(PointLanes<IntegerLanes> point, IntegerLanes center) {
  const Integers d;
  const auto zero = hn::Zero(d);
  const auto negative_center = zero - center;
  const auto positive = hn::Not(hn::Or(point.s < zero, point.t < zero));
  const auto negative = hn::Not(hn::Or(point.s > zero, point.t > zero));
  const auto corner = [&](IntegerLanes coordinate) HWY_ATTR {
    const auto by_sign = hn::IfThenElse(coordinate > zero, center, negative_center);
    return hn::IfThenElse(positive, center, hn::IfThenElse(negative, negative_center, by_sign));
  };
  const auto corner_s = corner(point.s), corner_t = corner(point.t);
  const auto s = point.s + point.s - corner_s, t = point.t + point.t - corner_t;
  const auto alike = corner_s == corner_t;
  return {hn::ShiftRight<1>(hn::IfThenElse(alike, zero - t, t) + corner_s),
          hn::ShiftRight<1>(hn::IfThenElse(alike, zero - s, s) + corner_t)};
}

void steps_lanes(const Octahedron& octahedron, const std::int32_t* s, const std::int32_t* t, std::size_t count,
                 std::uint32_t* steps) {
  const Integers d;
  const auto zero = hn::Zero(d), center = hn::Set(d, octahedron.center()), all = hn::Set(d, octahedron.steps());
  const auto select = [](auto mask, PointLanes<IntegerLanes> yes, PointLanes<IntegerLanes> no) HWY_ATTR {
    return PointLanes<IntegerLanes>{hn::IfThenElse(mask, yes.s, no.s), hn::IfThenElse(mask, yes.t, no.t)};
  };
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
    PointLanes<IntegerLanes> from = {hn::LoadU(d, s + i) - center, hn::LoadU(d, t + i) - center};
    PointLanes<IntegerLanes> to = {hn::LoadU(d, s + i + 1) - center, hn::LoadU(d, t + i + 1) - center};
    const auto outside = hn::Abs(from.s) + hn::Abs(from.t) > center;
    if (!hn::AllFalse(d, outside)) {
      to = select(outside, mirrored_lanes(to, center), to);
      from = select(outside, mirrored_lanes(from, center), from);
    }
    const auto one = hn::And(hn::Not(from.s < zero), from.t < zero);
    const auto two = hn::And(from.s > zero, hn::Not(from.t < zero));
    const auto three = hn::And(hn::Not(from.s > zero), from.t > zero);
    const auto turned = [&](PointLanes<IntegerLanes> p) HWY_ATTR {
      PointLanes<IntegerLanes> result = select(one, {p.t, zero - p.s}, p);
      result = select(two, {zero - p.s, zero - p.t}, result);
      return select(three, {zero - p.t, p.s}, result);
    };
    const PointLanes<IntegerLanes> a = turned(from), b = turned(to);
    const auto positive = [&](IntegerLanes step) HWY_ATTR { return step + hn::IfThenElseZero(step < zero, all); };
    hn::StoreInterleaved2(positive(b.s - a.s), positive(b.t - a.t), d, reinterpret_cast<std::int32_t*>(steps) + 2 * i);
  }
  for (; i < count; ++i) {
    const SquarePoint step = octahedron.step({s[i], t[i]}, {s[i + 1], t[i + 1]});
    steps[2 * i] = static_cast<std::uint32_t>(step.s);
    steps[2 * i + 1] = static_cast<std::uint32_t>(step.t);
  }
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dini {
HWY_EXPORT(quantize_two);
HWY_EXPORT(quantize_three);
HWY_EXPORT(predict_lanes);
HWY_EXPORT(points_lanes);
HWY_EXPORT(steps_lanes);

namespace kernels {

void quantize(std::span<const std::array<float, 2>> values, const Steps& steps, Row* rows) {
  HWY_DYNAMIC_DISPATCH(quantize_two)(values, steps, rows);
}

void quantize(std::span<const std::array<float, 3>> values, const Steps& steps, Row* rows) {
  HWY_DYNAMIC_DISPATCH(quantize_three)(values, steps, rows);
}

void predict(const Row* rows, const VertexOrder& order, std::int32_t minimum, std::int32_t maximum,
             std::uint32_t* left) {
  HWY_DYNAMIC_DISPATCH(predict_lanes)(rows, order, minimum, maximum, left);
}

void octahedron_points(const Octahedron& octahedron, const float* const (&directions)[3], std::size_t count,
                       std::int32_t* s, std::int32_t* t) {
  HWY_DYNAMIC_DISPATCH(points_lanes)(octahedron, directions, count, s, t);
}

void octahedron_steps(const Octahedron& octahedron, const std::int32_t* s, const std::int32_t* t, std::size_t count,
                      std::uint32_t* steps) {
  HWY_DYNAMIC_DISPATCH(steps_lanes)(octahedron, s, t, count, steps);
}

}  // namespace kernels
}  // namespace dini
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algebra/kernel_warp.cpp"
// clang-format off: this compiles the file once per instruction set, so it comes before all other headers
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// clang-format on

#include "algebra/boost-inl.h"
#include "algebra/kernels-inl.h"
#include "algebra/warp-inl.h"
#include "algebra/warp_source.h"

HWY_BEFORE_NAMESPACE();
namespace dini::HWY_NAMESPACE {

using Sources = std::span<const kernels::WarpSource>;

/// True where p is at a generator whose weight is unbounded there.
HWY_INLINE LaneMask at_a_generator(Sources sources, const Triple<Lanes>& p) {
  const Tag d;
  Lanes nearest = hn::Set(d, std::numeric_limits<double>::infinity());
  for (const kernels::WarpSource& source : sources) {
    const Triple<Lanes> y = broadcast(to_vector(source.position)) - p;
    nearest = hn::Min(nearest, hn::Max(hn::Max(hn::Abs(y.x), hn::Abs(y.y)), hn::Abs(y.z)));
  }
  return hn::Lt(nearest, hn::Set(d, tolerance::at_generator));
}

/// One rotor of the weighted sum.
template <Falloff falloff, bool exact, bool pairs>
void warp_by_sum(Sources sources, const kernels::WarpSettings& settings, kernels::ConstPoints in, kernels::Points out,
                 std::size_t count) {
  const Tag d;
  const WarpLanes lanes{hn::Set(d, settings.strength), hn::Set(d, settings.softening),
                        hn::Set(d, 0.5 * settings.power)};
  Vector tangents;
  for (const kernels::WarpSource& source : sources) tangents = tangents + source.generator.no_e;
  const Triple<Lanes> half_tangents = broadcast((0.5 * settings.strength) * tangents);
  const bool singular = settings.softening == 0 && settings.power > 0;
  for_each_range(count, [&](Range range) HWY_ATTR {
    const PointLanes p = load(in, range);
    Bivector<Lanes> sum;
    if constexpr (pairs) {
      sum = sum_of_pairs<falloff>(sources, lanes, half_tangents, p.position);
    } else {
      sum = sum_of_generators<falloff>(sources, lanes, p.position);
    }
    Triple<Lanes> image = displaced<exact>(p.position, sum, squares_of(d, sum));
    const LaneMask finite = is_finite(image);
    if (HWY_UNLIKELY(singular && !hn::AllTrue(d, finite))) {
      image = select(hn::AndNot(finite, at_a_generator(sources, p.position)), p.position, image);
    }
    const Lanes infinity = hn::Set(d, std::numeric_limits<double>::infinity());
    store(select(p.infinite, {infinity, infinity, infinity}, image), out, range);
  });
}

/// The displacements by each generator alone, added. Also the whole of a warp by one null pair.
template <Falloff falloff, bool exact, bool pairs>
void warp_by_displacements(Sources sources, const kernels::WarpSettings& settings, kernels::ConstPoints in,
                           kernels::Points out, std::size_t count) {
  const Tag d;
  const WarpLanes lanes{hn::Set(d, settings.strength), hn::Set(d, settings.softening),
                        hn::Set(d, 0.5 * settings.power)};
  const Lanes zero = hn::Zero(d);
  const Lanes at_generator = hn::Set(d, tolerance::at_generator * tolerance::at_generator);
  for_each_range(count, [&](Range range) HWY_ATTR {
    const PointLanes p = load(in, range);
    Triple<Lanes> moved{zero, zero, zero};
    for (const kernels::WarpSource& source : sources) {
      const Triple<Lanes> y = broadcast(to_vector(source.position)) - p.position;
      const Lanes yy = dot(y, y);
      const Lanes w = weight_at<falloff>(yy, lanes.strength, lanes.softening, lanes.half_power);
      Triple<Lanes> step;
      if constexpr (pairs) {
        const Triple<Lanes> from_generator{zero - y.x, zero - y.y, zero - y.z};
        const Boosted boost = boosted(from_generator, yy, w * broadcast(source.generator.no_e));
        step = select(boost.near, boost.offset, y + boost.offset);
      } else {
        const Bivector<Lanes> b = w * seen_from_point(source, y, yy);
        step = displaced<exact>({zero, zero, zero}, b, squares_of(d, b));
      }
      const LaneMask stays =
          settings.softening == 0 && settings.power > 0 ? hn::Le(yy, at_generator) : hn::Lt(yy, zero);
      moved = moved + select(stays, {zero, zero, zero}, step);
    }
    const Lanes infinity = hn::Set(d, std::numeric_limits<double>::infinity());
    store(select(p.infinite, {infinity, infinity, infinity}, p.position + moved), out, range);
  });
}

using Warp = void (*)(Sources, const kernels::WarpSettings&, kernels::ConstPoints, kernels::Points, std::size_t);

template <Falloff falloff>
Warp choose_warp(bool displacements, bool exact, bool pairs) {
  if (displacements) {
    if (pairs) return warp_by_displacements<falloff, true, true>;
    return exact ? warp_by_displacements<falloff, true, false> : warp_by_displacements<falloff, false, false>;
  }
  if (pairs) return exact ? warp_by_sum<falloff, true, true> : warp_by_sum<falloff, false, true>;
  return exact ? warp_by_sum<falloff, true, false> : warp_by_sum<falloff, false, false>;
}

void warp_lanes(Sources sources, const kernels::WarpSettings& settings, bool pairs, kernels::ConstPoints in,
                kernels::Points out, std::size_t count) {
  const bool exact = settings.rule == Rule::exact;
  const bool displacements =
      settings.method == kernels::WarpMethod::sum_displacements || (pairs && sources.size() == 1);
  const Warp warp = settings.power != 2       ? choose_warp<Falloff::general>(displacements, exact, pairs)
                    : settings.softening != 0 ? choose_warp<Falloff::softened_square>(displacements, exact, pairs)
                                              : choose_warp<Falloff::inverse_square>(displacements, exact, pairs);
  warp(sources, settings, in, out, count);
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dini {
HWY_EXPORT(warp_lanes);

namespace kernels {
void warp_points(std::span<const WarpSource> sources, const WarpSettings& settings, ConstPoints in, Points out,
                 std::size_t count) {
  bool pairs = true;
  for (const WarpSource& source : sources) pairs = pairs && is_null_pair(source);
  HWY_DYNAMIC_DISPATCH(warp_lanes)(sources, settings, pairs, in, out, count);
}
}  // namespace kernels
}  // namespace dini
#endif

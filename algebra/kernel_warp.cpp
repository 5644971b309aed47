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

/// Calls body(piece) for consecutive pieces of the sources, and asks whether to stop about once a millisecond.
class Pieces {
 public:
  Pieces(Sources sources, kernels::Stop stop) : sources_(sources), stop_(stop) {}

  bool stopped() const { return stopped_; }

  template <class Body>
  HWY_INLINE void for_each(Body body) {
    for (std::size_t first = 0; first < sources_.size() && !stopped_; first += most) {
      const Sources piece = sources_.subspan(first, std::min(most, sources_.size() - first));
      body(piece);
      done_ += piece.size();
      if (done_ < between_looks) continue;
      done_ = 0;
      stopped_ = stop_();
    }
  }

 private:
  static constexpr std::size_t most = std::size_t{1} << 14, between_looks = std::size_t{1} << 16;

  Sources sources_;
  kernels::Stop stop_;
  std::size_t done_ = 0;
  bool stopped_ = false;
};

/// True where p is at a generator whose weight is unbounded there.
HWY_INLINE LaneMask at_a_generator(Pieces& pieces, const Triple<Lanes>& p) {
  const Tag d;
  Lanes nearest = hn::Set(d, std::numeric_limits<double>::infinity());
  pieces.for_each([&](Sources piece) HWY_ATTR {
    for (const kernels::WarpSource& source : piece) {
      const Triple<Lanes> y = broadcast(to_vector(source.position)) - p;
      nearest = hn::Min(nearest, hn::Max(hn::Max(hn::Abs(y.x), hn::Abs(y.y)), hn::Abs(y.z)));
    }
  });
  return hn::Lt(nearest, hn::Set(d, tolerance::at_generator));
}

/// One rotor of the weighted sum.
template <Falloff falloff, bool exact, bool pairs>
void warp_by_sum(const kernels::WarpField& field, const kernels::WarpSettings& settings, kernels::ConstPoints in,
                 kernels::Points out, std::size_t count, kernels::Stop stop) {
  const Tag d;
  const WarpLanes lanes = lanes_of(settings);
  const Triple<Lanes> half_tangents = broadcast((0.5 * settings.strength) * field.sum_of_tangents());
  const bool singular = settings.softening == 0 && settings.power > 0;
  Pieces pieces(field.sources(), stop);
  for_each_range(count, [&](Range range) HWY_ATTR {
    if (HWY_UNLIKELY(pieces.stopped())) return;
    const PointLanes p = load(in, range);
    Bivector<Lanes> sum = no_generator();
    pieces.for_each([&](Sources piece) HWY_ATTR {
      if constexpr (pairs) {
        add_pairs<falloff>(piece, lanes, p.position, sum);
      } else {
        add_generators<falloff>(piece, lanes, p.position, sum);
      }
    });
    if constexpr (pairs && falloff == Falloff::inverse_square) sum.M = sum.M - half_tangents;
    Triple<Lanes> image = displaced<exact>(p.position, sum, squares_of(d, sum));
    const LaneMask finite = is_finite(image);
    if (HWY_UNLIKELY(singular && !hn::AllTrue(d, finite))) {
      image = select(hn::AndNot(finite, at_a_generator(pieces, p.position)), p.position, image);
    }
    const Lanes infinity = hn::Set(d, std::numeric_limits<double>::infinity());
    store(select(p.infinite, {infinity, infinity, infinity}, image), out, range);
  });
}

/// The displacements by each generator alone, added. Also the whole of a warp by one null pair.
template <Falloff falloff, bool exact, bool pairs>
void warp_by_displacements(const kernels::WarpField& field, const kernels::WarpSettings& settings,
                           kernels::ConstPoints in, kernels::Points out, std::size_t count, kernels::Stop stop) {
  const Tag d;
  const WarpLanes lanes = lanes_of(settings);
  const Lanes zero = hn::Zero(d);
  const Lanes at_generator = hn::Set(d, tolerance::at_generator * tolerance::at_generator);
  Pieces pieces(field.sources(), stop);
  const auto add_displacement = [&](const kernels::WarpSource& source, const PointLanes& p,
                                    Triple<Lanes>& moved) HWY_ATTR {
    const Triple<Lanes> y = broadcast(to_vector(source.position)) - p.position;
    const Lanes yy = dot(y, y);
    const Lanes w = weight_at<falloff>(yy, lanes);
    Triple<Lanes> step;
    if constexpr (pairs) {
      const Triple<Lanes> from_generator{zero - y.x, zero - y.y, zero - y.z};
      const Boosted boost = boosted(from_generator, yy, w * broadcast(source.generator.no_e));
      step = select(boost.near, boost.offset, y + boost.offset);
    } else {
      const Bivector<Lanes> b = w * seen_from_point(source, y, yy);
      step = displaced<exact>({zero, zero, zero}, b, squares_of(d, b));
    }
    const LaneMask stays = settings.softening == 0 && settings.power > 0 ? hn::Le(yy, at_generator) : hn::Lt(yy, zero);
    moved = moved + select(stays, {zero, zero, zero}, step);
  };
  for_each_range(count, [&](Range range) HWY_ATTR {
    if (HWY_UNLIKELY(pieces.stopped())) return;
    const PointLanes p = load(in, range);
    Triple<Lanes> moved{zero, zero, zero};
    pieces.for_each([&](Sources piece) HWY_ATTR {
      for (const kernels::WarpSource& source : piece) add_displacement(source, p, moved);
    });
    const Lanes infinity = hn::Set(d, std::numeric_limits<double>::infinity());
    store(select(p.infinite, {infinity, infinity, infinity}, p.position + moved), out, range);
  });
}

using Warp = void (*)(const kernels::WarpField&, const kernels::WarpSettings&, kernels::ConstPoints, kernels::Points,
                      std::size_t, kernels::Stop);

template <Falloff falloff>
Warp choose_warp(bool displacements, bool exact, bool pairs) {
  if (displacements) {
    if (pairs) return warp_by_displacements<falloff, true, true>;
    return exact ? warp_by_displacements<falloff, true, false> : warp_by_displacements<falloff, false, false>;
  }
  if (pairs) return exact ? warp_by_sum<falloff, true, true> : warp_by_sum<falloff, false, true>;
  return exact ? warp_by_sum<falloff, true, false> : warp_by_sum<falloff, false, false>;
}

void warp_lanes(const kernels::WarpField& field, const kernels::WarpSettings& settings, kernels::ConstPoints in,
                kernels::Points out, std::size_t count, kernels::Stop stop) {
  const bool pairs = field.null_pairs_only();
  const bool exact = settings.rule == Rule::exact;
  const bool displacements =
      settings.method == kernels::WarpMethod::sum_displacements || (pairs && field.sources().size() == 1);
  const auto choose = settings.power != 2       ? quarter_power(0.5 * settings.power) ? choose_warp<Falloff::quarters>
                                                                                      : choose_warp<Falloff::general>
                            : settings.softening != 0 ? choose_warp<Falloff::softened_square>
                                                : choose_warp<Falloff::inverse_square>;
  const Warp warp = choose(displacements, exact, pairs);
  warp(field, settings, in, out, count, stop);
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dini {
HWY_EXPORT(warp_lanes);

namespace kernels {
WarpField::WarpField(std::span<const WarpSource> sources, Stop stop) : sources_(sources) {
  constexpr std::size_t between_looks = 1 << 14;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (i % between_looks == 0 && stop()) return;
    null_pairs_only_ = null_pairs_only_ && is_null_pair(sources[i]);
    sum_of_tangents_ = sum_of_tangents_ + sources[i].generator.no_e;
  }
}

void warp_points(const WarpField& field, const WarpSettings& settings, ConstPoints in, Points out, std::size_t count,
                 Stop stop) {
  HWY_DYNAMIC_DISPATCH(warp_lanes)(field, settings, in, out, count, stop);
}
}  // namespace kernels
}  // namespace dini
#endif

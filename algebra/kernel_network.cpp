#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algebra/kernel_network.cpp"
// clang-format off: this compiles the file once per instruction set, so it comes before all other headers
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// clang-format on

#include "algebra/kernels-inl.h"
#include "algebra/network.h"
#include "algebra/warp-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dini::HWY_NAMESPACE {

/// The sum of products of some points, seen from each of them; there it has no e^e part.
struct ProductSum {
  Triple<Lanes> A;
  Lanes e;
  Triple<Lanes> M;
};

/// Adds the products with one more neighbor of each.
template <Falloff falloff>
HWY_INLINE void add_product(const WarpLanes& falloff_lanes, Lanes square_of_rest, const Triple<Lanes>& p, Lanes weight,
                            const Triple<Lanes>& other, Lanes other_weight, ProductSum& sum) {
  const Tag d;
  const Lanes zero = hn::Zero(d), one = hn::Set(d, 1.0), half = hn::Set(d, 0.5), quarter = hn::Set(d, 0.25);
  const Triple<Lanes> y = other - p;
  const Lanes yy = dot(y, y);
  const Lanes factor = weight_at<falloff>(yy, falloff_lanes) * (one - square_of_rest / yy);
  const Lanes amount = hn::IfThenElseZero(hn::Gt(yy, zero), factor);
  const Triple<Lanes> h = half * y;
  const Lanes hh = quarter * yy;
  sum.A = sum.A + (amount * (weight + other_weight)) * h;
  sum.e = sum.e + (amount * half) * (hh * ((weight + weight) + (weight + other_weight)));
  sum.M = sum.M - (amount * (one - weight) * hh) * h;
}

/// The neighbors number m of the points of a range.
struct NeighborLanes {
  Triple<Lanes> position;
  Lanes weight;
};
HWY_INLINE NeighborLanes gathered(const kernels::Network& network, std::size_t m, Range range) {
  const Tag d;
  HWY_ALIGN double x[most_lanes], y[most_lanes], z[most_lanes], weight[most_lanes];
  const std::uint32_t* indices = network.neighbors.indices + m * network.count + range.first;
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
    const std::uint32_t j = indices[i < range.valid ? i : 0];
    x[i] = network.points.x[j];
    y[i] = network.points.y[j];
    z[i] = network.points.z[j];
    weight[i] = network.weights[j];
  }
  return {{hn::Load(d, x), hn::Load(d, y), hn::Load(d, z)}, hn::Load(d, weight)};
}

/// The step as long as it may be, and its end within the ball.
HWY_INLINE Triple<Lanes> bounded(const kernels::NetworkSettings& settings, const Triple<Lanes>& p,
                                 const Triple<Lanes>& step) {
  const Tag d;
  const Lanes one = hn::Set(d, 1.0), longest = hn::Set(d, settings.longest_step), radius = hn::Set(d, settings.radius);
  const Lanes size = hn::Sqrt(dot(step, step));
  const Lanes share = hn::IfThenElse(hn::Gt(size, longest), longest / size, one);
  const Triple<Lanes> center = broadcast(to_vector(settings.center));
  const Triple<Lanes> from_center = (p + share * step) - center;
  const Lanes away = hn::Sqrt(dot(from_center, from_center));
  return center + hn::IfThenElse(hn::Gt(away, radius), radius / away, one) * from_center;
}

template <Falloff falloff>
void network_points(const kernels::NetworkSettings& settings, const kernels::Network& network, std::size_t begin,
                    std::size_t end, kernels::Points steps, kernels::Points out, kernels::Stop stop) {
  const Tag d;
  kernels::WarpSettings as_warp;
  as_warp.strength = settings.strength;
  as_warp.power = settings.power;
  as_warp.softening = settings.softening;
  const WarpLanes falloff_lanes = lanes_of(as_warp);
  const Lanes zero = hn::Zero(d), kept = hn::Set(d, 1 - settings.damping);
  const Lanes square_of_rest = hn::Set(d, settings.rest * settings.rest);
  const Triple<Lanes> nowhere{zero, zero, zero};
  bool stopped = false;
  for_each_range(end - begin, [&](Range part) HWY_ATTR {
    if (HWY_UNLIKELY(stopped)) return;
    const Range range{begin + part.first, part.valid};
    const Triple<Lanes> p{load(network.points.x, range), load(network.points.y, range), load(network.points.z, range)};
    const Lanes weight = load(network.weights, range);
    ProductSum sum{nowhere, zero, nowhere};
    if (network.neighbors.indices != nullptr) {
      for (std::size_t m = 0; m < network.neighbors.each; ++m) {
        const NeighborLanes other = gathered(network, m, range);
        add_product<falloff>(falloff_lanes, square_of_rest, p, weight, other.position, other.weight, sum);
      }
    } else {
      for (std::size_t j = 0; j < network.count; ++j) {
        const Triple<Lanes> other{hn::Set(d, network.points.x[j]), hn::Set(d, network.points.y[j]),
                                  hn::Set(d, network.points.z[j])};
        add_product<falloff>(falloff_lanes, square_of_rest, p, weight, other, hn::Set(d, network.weights[j]), sum);
      }
      stopped = stop();
    }
    const Bivector<Lanes> local{sum.A, nowhere, sum.e, sum.M};
    Triple<Lanes> carried = displaced<true>(nowhere, local, squares_of(d, local));
    carried = select(is_finite(carried), carried, nowhere);
    const Triple<Lanes> last{load(steps.x, range), load(steps.y, range), load(steps.z, range)};
    const Triple<Lanes> image = bounded(settings, p, carried + kept * last);
    store(image, out, range);
    store(image - p, steps, range);
  });
}

void network_lanes(const kernels::NetworkSettings& settings, const kernels::Network& network, std::size_t begin,
                   std::size_t end, kernels::Points steps, kernels::Points out, kernels::Stop stop) {
  const auto run = settings.power != 2       ? quarter_power(0.5 * settings.power) ? network_points<Falloff::quarters>
                                                                                   : network_points<Falloff::general>
                         : settings.softening != 0 ? network_points<Falloff::softened_square>
                                             : network_points<Falloff::inverse_square>;
  run(settings, network, begin, end, steps, out, stop);
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dini {
HWY_EXPORT(network_lanes);

namespace kernels {
void step_network(const NetworkSettings& settings, const Network& network, std::size_t begin, std::size_t end,
                  Points steps, Points out, Stop stop) {
  HWY_DYNAMIC_DISPATCH(network_lanes)(settings, network, begin, end, steps, out, stop);
}
}  // namespace kernels
}  // namespace dini
#endif

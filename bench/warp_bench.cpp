// Warps, boosts and bilinear blends of a million points on one thread, beside what a general-purpose geometric algebra
// library does for the same formula ("plain": ten coefficients summed in global coordinates, one cosh/cos exponential,
// one sandwich, center).

#include <benchmark/benchmark.h>
#include <cmath>
#include <vector>

#include "algebra/construct.h"
#include "algebra/kernels.h"
#include "algebra/versor.h"

namespace dini {
namespace {

constexpr std::size_t point_count = 1'000'000;

struct Cloud {
  std::vector<double> x = std::vector<double>(point_count), y = x, z = x;
  kernels::ConstPoints in() const { return {x.data(), y.data(), z.data()}; }
  kernels::Points out() { return {x.data(), y.data(), z.data()}; }
};

double uniform(std::uint64_t& state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return static_cast<double>(state >> 11) * 0x1p-52 - 1;
}

const Cloud& points() {
  static const Cloud cloud = [] {
    Cloud result;
    std::uint64_t state = 1;
    for (std::size_t i = 0; i < point_count; ++i) {
      result.x[i] = 2 * uniform(state);
      result.y[i] = 2 * uniform(state);
      result.z[i] = 2 * uniform(state);
    }
    return result;
  }();
  return cloud;
}

std::vector<kernels::WarpSource> sources(std::size_t count) {
  std::vector<kernels::WarpSource> result;
  std::uint64_t state = 2;
  for (std::size_t i = 0; i < count; ++i) {
    const Point c{2 * uniform(state), 2 * uniform(state), 2 * uniform(state)};
    const double size = 0.5 / static_cast<double>(count);
    result.push_back({null_pair(c, {size * uniform(state), size * uniform(state), size * uniform(state)}), c});
  }
  return result;
}

void report(benchmark::State& state) {
  state.counters["Mpoint/s"] = benchmark::Counter(
      1e-6 * static_cast<double>(point_count) * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

/// The yardstick: straightforward scalar code, compiled with the same flags.
Point plain_image(const std::vector<kernels::WarpSource>& generators, const Vector& x) {
  Generator sum;
  for (const auto& source : generators) {
    const double weight = -0.5 / squared_length(x - to_vector(source.position));
    sum = sum + weight * source.generator;
  }
  const double square = sum.no_ni * sum.no_ni - squared_length(sum.e_e) - 2 * dot(sum.no_e, sum.e_ni);
  const double size = std::sqrt(std::abs(square));
  const double scalar = square > 0 ? std::cosh(size) : square < 0 ? std::cos(size) : 1;
  const double factor = square > 0 ? std::sinh(size) / size : square < 0 ? std::sin(size) / size : 1;
  // R p: a vector v and a trivector t; then the vector part of (v + t) ~R
  const auto& [A, W, e, M] = factor * sum;
  const double beta = 0.5 * squared_length(x);
  const double v_no = scalar - e + dot(A, x), v_ni = scalar * beta + e * beta - dot(M, x);
  const Vector v = scalar * x + beta * A + cross(x, W) - M;
  const double t_e = dot(x, W);
  const Vector t_no = cross(A, x) + W, t_ni = cross(x, M) + beta * W, t_mixed = beta * A - e * x + M;
  const double weight = v_no * (scalar - e) + dot(A, v) + dot(t_no, W) + dot(t_mixed, A);
  const Vector image =
      scalar * v + v_ni * A + cross(v, W) - v_no * M + t_e * W + e * t_mixed + cross(t_no, M) + cross(A, t_ni);
  return to_point(image / weight);
}

void plain_warp(benchmark::State& state) {
  const auto generators = sources(static_cast<std::size_t>(state.range(0)));
  const Cloud& in = points();
  Cloud out, expected;
  for (auto _ : state) {
    for (std::size_t i = 0; i < point_count; ++i) {
      const Point image = plain_image(generators, {in.x[i], in.y[i], in.z[i]});
      out.x[i] = image.x;
      out.y[i] = image.y;
      out.z[i] = image.z;
    }
    benchmark::ClobberMemory();
  }
  kernels::warp_points(kernels::WarpField(generators), {-0.5, 2, 0, Rule::paper, kernels::WarpMethod::sum_generators},
                       in.in(), expected.out(), 1000);
  for (std::size_t i = 0; i < 1000; ++i) {
    if (std::abs(out.x[i] - expected.x[i]) > 1e-6) state.SkipWithError("the yardstick computes something else");
  }
  report(state);
}
BENCHMARK(plain_warp)->Arg(1)->Arg(4)->Arg(16)->Arg(64)->Unit(benchmark::kMillisecond);

void warp(benchmark::State& state, Rule rule, kernels::WarpMethod method, double power) {
  const auto generators = sources(static_cast<std::size_t>(state.range(0)));
  Cloud out;
  for (auto _ : state) {
    kernels::warp_points(kernels::WarpField(generators), {-0.5, power, 0, rule, method}, points().in(), out.out(),
                         point_count);
    benchmark::ClobberMemory();
  }
  report(state);
}
void warp_exact(benchmark::State& state) { warp(state, Rule::exact, kernels::WarpMethod::sum_generators, 2); }
void warp_paper(benchmark::State& state) { warp(state, Rule::paper, kernels::WarpMethod::sum_generators, 2); }
void warp_displacements(benchmark::State& state) {
  warp(state, Rule::exact, kernels::WarpMethod::sum_displacements, 2);
}
void warp_power_3(benchmark::State& state) { warp(state, Rule::exact, kernels::WarpMethod::sum_generators, 3); }
BENCHMARK(warp_exact)->Arg(1)->Arg(4)->Arg(16)->Arg(64)->Unit(benchmark::kMillisecond);
BENCHMARK(warp_paper)->Arg(1)->Arg(4)->Arg(16)->Arg(64)->Unit(benchmark::kMillisecond);
BENCHMARK(warp_displacements)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK(warp_power_3)->Arg(16)->Unit(benchmark::kMillisecond);

void boost(benchmark::State& state) {
  Cloud out;
  const double amount = 0.7;
  for (auto _ : state) {
    kernels::boost_points({1, 2, 3}, {0.2, 0.1, 0.4}, {&amount, true}, points().in(), out.out(), point_count);
    benchmark::ClobberMemory();
  }
  report(state);
}
BENCHMARK(boost)->Unit(benchmark::kMillisecond);

void transform(benchmark::State& state) {
  Cloud out;
  const Versor versor = exponential(sources(1)[0].generator + sources(2)[1].generator);
  for (auto _ : state) {
    kernels::transform_points(versor, points().in(), out.out(), point_count);
    benchmark::ClobberMemory();
  }
  report(state);
}
BENCHMARK(transform)->Unit(benchmark::kMillisecond);

void bilinear(benchmark::State& state, Rule rule) {
  const kernels::BilinearCorners corners{null_pair({-1, -1, 0}, {0.3, 0, 1}), null_pair({1, -1, 0}, {0, 0.4, -0.8}),
                                         null_pair({-1, 1, 0}, {0.1, -0.3, -0.5}),
                                         null_pair({1, 1, 0}, {-0.2, 0.1, 0.6})};
  Cloud out;
  const double amount = -0.5;
  for (auto _ : state) {
    kernels::transform_points_bilinear(corners, {points().x.data(), false}, {points().y.data(), false}, {&amount, true},
                                       rule, points().in(), out.out(), point_count);
    benchmark::ClobberMemory();
  }
  report(state);
}
void bilinear_exact(benchmark::State& state) { bilinear(state, Rule::exact); }
void bilinear_paper(benchmark::State& state) { bilinear(state, Rule::paper); }
BENCHMARK(bilinear_exact)->Unit(benchmark::kMillisecond);
BENCHMARK(bilinear_paper)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace dini

BENCHMARK_MAIN();

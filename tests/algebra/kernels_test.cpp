// The SIMD kernels against the scalar algebra, against each other over instruction sets, and at their singular points.

#include "algebra/kernels.h"

#include <array>
#include <catch2/catch.hpp>
#include <functional>
#include <limits>
#include <vector>

#include "algebra/construct.h"
#include "algebra/versor.h"
#include "tests/support/close.h"
#include "tests/support/dense.h"
#include "tests/support/random_elements.h"

using namespace dini;
using namespace dini::kernels;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A column of points with its component arrays.
struct Cloud {
  std::vector<double> x, y, z;

  explicit Cloud(std::size_t size = 0) : x(size), y(size), z(size) {}
  std::size_t size() const { return x.size(); }
  Point operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void add(const Point& p) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
  ConstPoints in() const { return {x.data(), y.data(), z.data()}; }
  Points out() { return {x.data(), y.data(), z.data()}; }
  friend bool operator==(const Cloud&, const Cloud&) = default;
};

Cloud random_cloud(std::size_t size, double scale = 2) {
  RandomElements random(51);
  Cloud cloud;
  for (std::size_t i = 0; i < size; ++i) cloud.add(random.point(scale));
  return cloud;
}

std::vector<WarpSource> random_sources(int count, double scale = 0.5) {
  RandomElements random(52);
  std::vector<WarpSource> sources;
  for (int i = 0; i < count; ++i) {
    const Point c = random.point(2);
    sources.push_back({null_pair(c, random.vector(scale)), c});
  }
  return sources;
}

Cloud warped(const Cloud& cloud, const std::vector<WarpSource>& sources, const WarpSettings& settings) {
  Cloud result(cloud.size());
  warp_points(WarpField(sources), settings, cloud.in(), result.out(), cloud.size());
  return result;
}
Point warped(const Point& p, const std::vector<WarpSource>& sources, const WarpSettings& settings) {
  Cloud cloud;
  cloud.add(p);
  return warped(cloud, sources, settings)[0];
}

double weight_at(const WarpSource& source, const Point& p, const WarpSettings& settings) {
  return settings.strength / (std::pow(distance(p, source.position), settings.power) + settings.softening);
}

TEST_CASE("The boost kernel agrees with the exponential of a null pair") {
  RandomElements random(53);
  const Point c{0.5, -1, 2};
  const Vector t{0.3, 0.1, -0.7};
  const Cloud cloud = random_cloud(101);
  std::vector<double> amounts;
  for (std::size_t i = 0; i < cloud.size(); ++i) amounts.push_back(random.number(3));
  Cloud result(cloud.size());
  boost_points(c, t, {amounts.data(), false}, cloud.in(), result.out(), cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    require_close(result[i], *apply(exponential(amounts[i] * null_pair(c, t)), cloud[i]), 1e-11);
  }
}

TEST_CASE("The versor kernel agrees with the scalar action, also for the paper's operators") {
  RandomElements random(54);
  const Cloud cloud = random_cloud(67);
  for (const Versor& v : {exponential(random.generator()), random.versor(), translation_versor({1, 2, 3})}) {
    Cloud result(cloud.size());
    transform_points(v, cloud.in(), result.out(), cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) require_close(result[i], *apply(v, cloud[i]), 1e-11);
  }
}

TEST_CASE("Images of points far from a generator keep their digits") {
  using Long = dense::Multivector<long double>;
  RandomElements random(59);
  for (int i = 0; i < 300; ++i) {
    const Generator pairs = random.pair() + random.pair(), any = random.generator(),
                    tangent = null_pair(random.point(0.1), random.vector(30));
    for (const Generator& g : {random.pair(), pairs, any, tangent}) {
      const Long rotor = dense::exponential(dense::from<long double>(g));
      for (const double away : {1.0, 30.0, 1000.0}) {
        Cloud far, moved(1), by_versor(1);
        far.add(random.point(away));
        const Point p = far[0];
        const auto reference = dense::apply<long double>(rotor, p.x, p.y, p.z);
        const Point wanted = {static_cast<double>(reference[0]), static_cast<double>(reference[1]),
                              static_cast<double>(reference[2])};
        const double size = length(to_vector(wanted));
        if (!(size < 100 * away)) continue;  // near the pole every digit counts
        CAPTURE(i, away, p.x, p.y, p.z);
        const double most = 1e-12 * (size + 0.1);
        const std::array<double, 10> values = {g.no_e.x, g.no_e.y, g.no_e.z, g.e_e.x,  g.e_e.y,
                                               g.e_e.z,  g.no_ni,  g.e_ni.x, g.e_ni.y, g.e_ni.z};
        ConstGenerators one{{}, true};
        for (std::size_t k = 0; k < 10; ++k) one.components[k] = &values[k];
        const double amount = 1;
        transform_points(one, {&amount, true}, Rule::exact, far.in(), moved.out(), 1);
        transform_points(exponential(g), far.in(), by_versor.out(), 1);
        CHECK(distance(moved[0], wanted) <= most);
        CHECK(distance(by_versor[0], wanted) <= most);
        CHECK(distance(*apply(exponential(g), p), wanted) <= most);
      }
    }
  }
}

TEST_CASE("The generator and bilinear kernels agree with the scalar exponential") {
  RandomElements random(55);
  const Cloud cloud = random_cloud(45);
  const BilinearCorners corners{random.pair(), random.generator(), random.pair(), random.pair()};
  for (const Rule rule : {Rule::exact, Rule::paper}) {
    std::vector<std::array<double, 10>> columns;
    std::array<std::vector<double>, 10> components;
    std::vector<double> u, v;
    std::vector<Generator> blends;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      u.push_back(0.5 + random.number(0.7));
      v.push_back(0.5 + random.number(0.7));
      const Generator g = (1 - u[i]) * (1 - v[i]) * corners.a + u[i] * (1 - v[i]) * corners.b +
                          (1 - u[i]) * v[i] * corners.c + u[i] * v[i] * corners.d;
      blends.push_back(g);
      const double values[10] = {g.no_e.x, g.no_e.y, g.no_e.z, g.e_e.x,  g.e_e.y,
                                 g.e_e.z,  g.no_ni,  g.e_ni.x, g.e_ni.y, g.e_ni.z};
      for (std::size_t k = 0; k < 10; ++k) components[k].push_back(values[k]);
    }
    const double amount = 0.8;
    Cloud bilinear(cloud.size()), general(cloud.size());
    transform_points_bilinear(corners, {u.data(), false}, {v.data(), false}, {&amount, true}, rule, cloud.in(),
                              bilinear.out(), cloud.size());
    ConstGenerators generators{{}, false};
    for (std::size_t k = 0; k < 10; ++k) generators.components[k] = components[k].data();
    transform_points(generators, {&amount, true}, rule, cloud.in(), general.out(), cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const Point expected = *apply(exponential(amount * blends[i], rule), cloud[i]);
      require_close(bilinear[i], expected, 1e-11);
      require_close(general[i], expected, 1e-11);
    }
  }
}

TEST_CASE("Warps agree with the scalar algebra for every method, rule and falloff") {
  const Cloud cloud = random_cloud(53);
  auto mixed = random_sources(3);
  mixed.push_back(warp_source(0.2 * flat_point({0.5, 1, -1})));
  mixed.push_back(warp_source(0.1 * rotation_generator(line_from({1, 0, 0}, {0, 1, 1}))));
  mixed.push_back(warp_source(split_pair({-1, 0.5, 0}, {0.2, 0.1, 0}, 0.3)));
  for (const auto& sources : {random_sources(1), random_sources(5), mixed}) {
    for (const double power : {2.0, 1.0, 3.0, 4.0, 0.5, 1.5, 3.5, 2.7, -1.0, 0.0}) {
      for (const double softening : {0.0, 0.5}) {
        for (const Rule rule : {Rule::exact, Rule::paper}) {
          WarpSettings settings{0.7, power, softening, rule, WarpMethod::sum_generators};
          const Cloud summed = warped(cloud, sources, settings);
          settings.method = WarpMethod::sum_displacements;
          const Cloud displaced = warped(cloud, sources, settings);
          for (std::size_t i = 0; i < cloud.size(); ++i) {
            Generator sum;
            Vector moved;
            for (const WarpSource& source : sources) {
              const Generator g = weight_at(source, cloud[i], settings) * source.generator;
              sum = sum + g;
              moved = moved + (to_vector(*apply(exponential(g, rule), cloud[i])) - to_vector(cloud[i]));
            }
            require_close(summed[i], *apply(exponential(sum, rule), cloud[i]), 1e-10);
            require_close(displaced[i], to_point(to_vector(cloud[i]) + moved), 1e-10);
          }
        }
      }
    }
  }
}

TEST_CASE("Warps keep their digits near a generator") {
  RandomElements random(56);
  const auto sources = random_sources(4);
  for (double d = 1e-1; d > 1e-13; d *= 0.1) {
    for (const Rule rule : {Rule::exact, Rule::paper}) {
      // powers of two keep the coordinates of the generator relative to the point exact
      const Vector step = std::exp2(std::round(std::log2(d))) * Vector{0.75, -0.5, 0.25};
      const Point c = sources[0].position, p = to_point(to_vector(c) + step);
      const Vector exact_step = to_vector(p) - to_vector(c);
      // reference: the sum seen from the point, lengths in units of d so that the coefficients are balanced
      const long double unit = length(exact_step);
      dense::Multivector<long double> sum;
      for (const WarpSource& source : sources) {
        const long double y[3] = {(static_cast<long double>(source.position.x) - p.x) / unit,
                                  (static_cast<long double>(source.position.y) - p.y) / unit,
                                  (static_cast<long double>(source.position.z) - p.z) / unit};
        const long double yy = y[0] * y[0] + y[1] * y[1] + y[2] * y[2];
        const Vector& t = source.generator.no_e;
        const long double slope = y[0] * t.x + y[1] * t.y + y[2] * t.z;
        const auto no = dense::vector<long double>(1, 0, 0, 0, 0), ni = dense::vector<long double>(0, 0, 0, 0, 1);
        const auto tangent = dense::vector<long double>(0, t.x, t.y, t.z, 0);
        const auto place = dense::vector<long double>(0, y[0], y[1], y[2], 0);
        const auto pair =
            (no ^ tangent) + slope * (no ^ ni) + (place ^ tangent) + (((slope * place) + (-yy / 2) * tangent) ^ ni);
        sum = sum + (0.5L / (yy * unit)) * pair;
      }
      dense::Multivector<long double> rotor;
      if (rule == Rule::exact) {
        rotor = dense::exponential(sum, true);
      } else {
        const long double square = (sum * sum).c[0], n = std::sqrt(std::abs(square));
        rotor = square > 0 ? dense::scalar<long double>(1) + (std::tanh(n) / n) * sum
                           : dense::scalar<long double>(std::cos(n)) + (std::sin(n) / n) * sum;
      }
      const auto moved = dense::apply<long double>(rotor, 0, 0, 0);
      const Point expected{static_cast<double>(p.x + unit * moved[0]), static_cast<double>(p.y + unit * moved[1]),
                           static_cast<double>(p.z + unit * moved[2])};
      const Point value = warped(p, sources, {0.5, 2, 0, rule, WarpMethod::sum_generators});
      CAPTURE(d);
      REQUIRE(distance(value, expected) <= 4e-16 * length(to_vector(c)) + 1e-9 * d);
    }
  }
}

TEST_CASE("A point on a generator stays, and one far away is shifted by the sum of the reflections") {
  for (const int count : {1, 2, 7}) {
    const auto sources = random_sources(count);
    for (const Rule rule : {Rule::exact, Rule::paper}) {
      for (const double power : {1.0, 2.0, 4.0}) {
        const WarpSettings settings{1, power, 0, rule, WarpMethod::sum_generators};
        require_close(warped(sources[0].position, sources, settings), sources[0].position, 1e-15);
        const Point at_origin =
            warped({1e-200, 0, 0}, {{null_pair({0, 0, 0}, {1, 2, 3}), {0, 0, 0}}, sources[0]}, settings);
        REQUIRE(length(to_vector(at_origin)) < 1e-100);
        REQUIRE(warped(Point::at_infinity(), sources, settings) == Point::at_infinity());
      }
    }
  }
}

TEST_CASE("Kernels know infinity") {
  const double amount = 2;
  Cloud cloud;
  cloud.add(Point::at_infinity());
  cloud.add({-0.5, 0, 0});
  Cloud result(2);
  boost_points({0, 0, 0}, {1, 0, 0}, {&amount, true}, cloud.in(), result.out(), 2);
  require_close(result[0], {0.5, 0, 0});
  REQUIRE(result[1] == Point::at_infinity());
  const double zero = 0;
  boost_points({0, 0, 0}, {1, 0, 0}, {&zero, true}, cloud.in(), result.out(), 2);
  REQUIRE(result[0] == Point::at_infinity());
  REQUIRE(result[1] == cloud[1]);
  transform_points(exponential(2 * null_pair({0, 0, 0}, {1, 0, 0})), cloud.in(), result.out(), 2);
  require_close(result[0], {0.5, 0, 0});
  REQUIRE(result[1] == Point::at_infinity());
  transform_points(translation_versor({1, 0, 0}), cloud.in(), result.out(), 2);
  REQUIRE(result[0] == Point::at_infinity());
  ConstGenerators pair{{}, true};
  const double components[10] = {1, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  for (std::size_t k = 0; k < 10; ++k) pair.components[k] = &components[k];
  for (const Rule rule : {Rule::exact, Rule::paper}) {
    transform_points(pair, {&amount, true}, rule, cloud.in(), result.out(), 2);
    require_close(result[0], {0.5, 0, 0});
    REQUIRE(result[1] == Point::at_infinity());
  }
}

/// Every kernel on one cloud, in a row.
std::vector<Cloud> everything(const Cloud& cloud, double scale) {
  std::vector<Cloud> results;
  const auto run = [&](const std::function<void(Cloud&)>& kernel) {
    results.emplace_back(cloud.size());
    kernel(results.back());
  };
  RandomElements random(57);
  const double amount = 0.5 * scale;
  const BilinearCorners corners{scale * random.pair(), random.generator(), random.pair(), random.pair(scale)};
  const Versor versor = exponential(random.generator());
  auto sources = random_sources(6, scale);
  auto general = sources;
  general.push_back({scale * random.generator(), {0, 0, 0}});
  run([&](Cloud& out) { boost_points({0, 1, 0}, {1, 2, 3}, {&amount, true}, cloud.in(), out.out(), cloud.size()); });
  run([&](Cloud& out) { transform_points(versor, cloud.in(), out.out(), cloud.size()); });
  for (const Rule rule : {Rule::exact, Rule::paper}) {
    run([&](Cloud& out) {
      transform_points_bilinear(corners, {cloud.x.data(), false}, {cloud.y.data(), false}, {&amount, true}, rule,
                                cloud.in(), out.out(), cloud.size());
    });
    for (const WarpMethod method : {WarpMethod::sum_generators, WarpMethod::sum_displacements}) {
      for (const double power : {2.0, 2.5}) {
        for (const double softening : {0.0, 0.1}) {
          const WarpSettings settings{scale, power, softening, rule, method};
          run([&](Cloud& out) { out = warped(cloud, sources, settings); });
          run([&](Cloud& out) { out = warped(cloud, general, settings); });
        }
      }
    }
  }
  return results;
}

TEST_CASE("Every instruction set gives the same bits, tails included") {
  REQUIRE(instruction_sets().size() >= 1);
  REQUIRE_FALSE(force_instruction_set("no such thing"));
  for (const double scale : {1.0, 30.0}) {
    for (const std::size_t size : {1u, 7u, 64u, 203u}) {
      Cloud cloud = random_cloud(size);
      if (size > 3) cloud.x[3] = infinity;
      std::vector<Cloud> reference;
      for (const char* name : instruction_sets()) {
        CAPTURE(name, size, scale);
        REQUIRE(force_instruction_set(name));
        REQUIRE(std::string(current_instruction_set()) == name);
        const auto results = everything(cloud, scale);
        if (reference.empty()) reference = results;
        REQUIRE(results == reference);
      }
      REQUIRE(force_instruction_set(""));
    }
  }
}

TEST_CASE("No kernel makes NaN of finite input") {
  const double hostile[] = {0,   -0.0, 5e-324, 1e-310, -1e-160, 1e-80,  1e-8,  1,       -2,
                            1e8, 1e50, -1e99,  1e101,  1e155,   -1e200, 1e300, -1.7e308};
  Cloud cloud;
  for (const double x : hostile) {
    for (const double y : hostile) cloud.add({x, y, x + 1});
  }
  for (const double scale : {1.0, 0.0, 1e-300, 1e-20, 1e20, 1e100, 1e200, 1e300}) {
    for (const Cloud& result : everything(cloud, scale)) {
      for (std::size_t i = 0; i < result.size(); ++i) {
        const Point p = result[i];
        CAPTURE(scale, cloud[i].x, cloud[i].y, p.x, p.y, p.z);
        REQUIRE((is_finite(p) || p == Point::at_infinity()));
      }
    }
  }
}

}  // namespace

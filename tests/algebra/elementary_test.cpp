#include "algebra/elementary.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/support/random_elements.h"

namespace dini::elementary {
namespace {

template <class Value, class Reference>
void require_within(double ulps, Value value, Reference reference, double low, double high) {
  RandomElements random(41);
  for (int i = 0; i < 5000; ++i) {
    const double x = low + (high - low) * 0.5 * (1 + random.number());
    const long double expected = reference(static_cast<long double>(x));
    const double size = std::abs(static_cast<double>(expected));
    const double unit = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
    CAPTURE(x);
    REQUIRE(std::abs(static_cast<double>((value(x) - expected) / unit)) <= ulps);
  }
}

TEST_CASE("Elementary functions are within a few units in the last place") {
  using L = long double;
  require_within(
      1, exp, [](L x) { return std::exp(x); }, -700, 700);
  require_within(
      1, log, [](L x) { return std::log(x); }, 1e-3, 10);
  require_within(
      1, log10, [](L x) { return std::log10(x); }, 1e-3, 1e4);
  require_within(
      1, log2, [](L x) { return std::log2(x); }, 1e-3, 1e4);
  require_within(
      1, sin, [](L x) { return std::sin(x); }, -1e6, 1e6);
  require_within(
      1, cos, [](L x) { return std::cos(x); }, -1e6, 1e6);
  require_within(
      1, sin, [](L x) { return std::sin(x); }, 1e6, 1e12);
  require_within(
      2, tan, [](L x) { return std::tan(x); }, -10, 10);
  require_within(
      1, atan, [](L x) { return std::atan(x); }, -10, 10);
  require_within(
      3, asin, [](L x) { return std::asin(x); }, -1, 1);
  require_within(
      3, acos, [](L x) { return std::acos(x); }, -1, 1);
  require_within(
      3, sinh, [](L x) { return std::sinh(x); }, -30, 30);
  require_within(
      3, cosh, [](L x) { return std::cosh(x); }, -30, 30);
  require_within(
      3, tanh, [](L x) { return std::tanh(x); }, -3, 3);
  require_within(
      3, asinh, [](L x) { return std::asinh(x); }, -30, 30);
  require_within(
      3, acosh, [](L x) { return std::acosh(x); }, 1, 30);
  require_within(
      3, atanh, [](L x) { return std::atanh(x); }, -1, 1);
  require_within(
      1, cbrt, [](L x) { return std::cbrt(x); }, -1e6, 1e6);
  require_within(
      2, [](double x) { return pow(x, 3.7); }, [](L x) { return std::pow(x, static_cast<L>(3.7)); }, 0, 50);
  require_within(
      1, [](double x) { return hypot(x, 3); }, [](L x) { return std::hypot(x, 3.0L); }, -10, 10);
}

TEST_CASE("Elementary functions are exact where people look") {
  REQUIRE(log10(1000) == 3);
  REQUIRE(log2(8) == 3);
  REQUIRE(cbrt(27) == 3);
  REQUIRE(pow(2, 10) == 1024);
  REQUIRE(pow(-2, 3) == -8);
  REQUIRE(pow(0, 0) == 1);
  REQUIRE(pow(4, 0.5) == 2);
  REQUIRE(exp(0) == 1);
  REQUIRE(sin(0) == 0);
  REQUIRE(cos(0) == 1);
  REQUIRE(sincos_turns(0.25).cosine == 0);
  REQUIRE(sincos_turns(0.5).sine == 0);
  REQUIRE(sincos_turns(-0.75).sine == 1);
  REQUIRE(atan2(0, -1) == 3.14159265358979311600);
  REQUIRE(sin(1e22) == Approx(-0.85220084976718880177).epsilon(1e-15));
  REQUIRE(hypot(3e300, 4e300) == Approx(5e300));
}

TEST_CASE("Elementary functions meet the edges of the range") {
  const double infinity = std::numeric_limits<double>::infinity();
  REQUIRE(exp(1000) == infinity);
  REQUIRE(exp(-1000) == 0);
  REQUIRE(exp(709.7) < infinity);
  REQUIRE(log(0) == -infinity);
  REQUIRE(std::isnan(log(-1)));
  REQUIRE(log(5e-324) == Approx(-744.4400719213812));
  REQUIRE(pow(0, -1) == infinity);
  REQUIRE(pow(10, 400) == infinity);
  REQUIRE(pow(10, -400) == 0);
  REQUIRE(pow(1.0000000001, 1e300) == infinity);
  REQUIRE(std::isnan(pow(-1, 0.5)));
  REQUIRE(std::isnan(sin(infinity)));
  REQUIRE(std::isnan(exp(std::nan(""))));
  REQUIRE(tanh(1e300) == 1);
  REQUIRE(sinh(-1e300) == -infinity);
  REQUIRE(std::isnan(asin(1.5)));
  REQUIRE(atan(infinity) == Approx(1.5707963267948966));
  for (const double x : {1e15, 1e100, 1.7976931348623157e308}) REQUIRE(std::abs(sin(x)) <= 1);
}

}  // namespace
}  // namespace dini::elementary

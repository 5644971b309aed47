#include "algebra/elementary.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "algebra/elementary-inl.h"

namespace dini::elementary {

namespace {

namespace lanes = HWY_NAMESPACE;
namespace hn = hwy::HWY_NAMESPACE;

using One = hn::CappedTag<double, 1>;
constexpr One one_lane;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double pi_high = 3.14159265358979311600e+00, pi_low = 1.22464679914735317636e-16;

auto lane(double x) { return hn::Set(one_lane, x); }
template <class V>
double number(V v) {
  return hn::GetLane(v);
}

struct Sum {
  double high, low;
};
Sum logarithm(double x) {
  const auto result = lanes::logarithm_of(one_lane, lane(x));
  return {number(result.high), number(result.low)};
}

/// log(x) times (high + low), for the other bases.
double scaled_logarithm(double x, double high, double low) {
  if (!(x > 0) || x == infinity) return log(x);
  const Sum value = logarithm(x);
  const auto product = lanes::exact_product(one_lane, lane(value.high), lane(high));
  return number(product.high) + (number(product.low) + (value.high * low + value.low * high));
}

double log_one_plus(double x) {
  const double u = 1 + x;
  return u == infinity ? infinity : log(u) + (x - (u - 1)) / u;
}

bool is_odd_integer(double y) { return std::abs(y) < 0x1p53 && std::floor(y) == y && std::floor(y / 2) * 2 != y; }

/// atan on [0, 7/16] up to a breakpoint: fdlibm's polynomial in x^2.
double arctangent_polynomial(double x) {
  const double z = x * x, w = z * z;
  const double odd = z * (3.33333333333329318027e-01 +
                          w * (1.42857142725034663711e-01 +
                               w * (9.09088713343650656196e-02 +
                                    w * (6.66107313738753120669e-02 +
                                         w * (4.97687799461593236017e-02 + w * 1.62858201153657823623e-02)))));
  const double even =
      w *
      (-1.99999999998764832476e-01 +
       w * (-1.11111104054623557880e-01 +
            w * (-7.69187620504482999495e-02 + w * (-5.83357013379057348645e-02 + w * -3.65315727442169155270e-02))));
  return x * (odd + even);
}

}  // namespace

double exp(double x) { return number(lanes::exponential_of(one_lane, lane(x))); }

double log(double x) {
  if (!(x > 0)) return x == 0 ? -infinity : not_a_number;
  return x == infinity ? infinity : logarithm(x).high;
}

double log2(double x) {
  if (!(x > 0) || x == infinity) return log(x);
  // powers of two are exact: only the fraction goes through the division by log 2
  int exponent = 0;
  double fraction = std::frexp(x, &exponent);
  if (fraction < 0x1.6a09e667f3bcdp-1) {
    fraction *= 2;
    --exponent;
  }
  return exponent + scaled_logarithm(fraction, 1.44269504088896338700e+00, 2.03552737409310314e-17);
}

double log10(double x) { return scaled_logarithm(x, 4.34294481903251816668e-01, 1.09831965021676510e-17); }

double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (std::isnan(x) || std::isnan(y)) return not_a_number;
  const double base = std::abs(x);
  if (std::isinf(y)) return base == 1 ? 1 : (base > 1) == (y > 0) ? infinity : 0;
  const double sign = std::signbit(x) && is_odd_integer(y) ? -1 : 1;
  if (base == infinity) return sign * (y > 0 ? infinity : 0);
  if (x < 0 && std::floor(y) != y) return not_a_number;
  return sign * number(lanes::power_of(one_lane, lane(base), lane(y)));
}

ReducedAngle reduce_large_angle(double x) {
  // The binary digits of 2/pi, most significant first.
  static constexpr std::uint64_t digits[] = {
      0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561, 0xb7246e3a424dd2e0,
      0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484, 0xe99c7026b45f7e41, 0x3991d639835339f4,
      0x9c845f8bbdf9283b, 0x1ff897ffde05980f, 0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d,
      0x7527bac7ebe5f17b, 0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab};
  __extension__ using Wide = unsigned __int128;

  if (!std::isfinite(x)) return {0, not_a_number, 0};
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const int exponent = static_cast<int>((bits >> 52) & 0x7ff) - 1075;
  if (exponent < -64) return {0, x, 0};  // small: nothing to reduce
  const std::uint64_t mantissa = (bits & 0xfffffffffffff) | 0x10000000000000;

  // |x| 2/pi modulo 4, 190 bits after the point: only digits of weight 2 and below matter.
  const auto word_at = [](int first) -> std::uint64_t {  // 64 digits from number `first`, counted from 0
    std::uint64_t word = 0;
    for (int i = 0; i < 64; ++i) {
      const int at = first + i;
      word = (word << 1) | (at < 0 ? 0 : (digits[at / 64] >> (63 - at % 64)) & 1);
    }
    return word;
  };
  const int first = exponent - 2;
  const Wide low_product = Wide(mantissa) * word_at(first + 128);
  const Wide middle_product = Wide(mantissa) * word_at(first + 64) + (low_product >> 64);
  const std::uint64_t top = mantissa * word_at(first) + static_cast<std::uint64_t>(middle_product >> 64);
  const std::uint64_t middle = static_cast<std::uint64_t>(middle_product);
  double quadrant = static_cast<double>(top >> 62);
  Wide fraction = (((Wide(top) << 64) | middle) << 2) | (static_cast<std::uint64_t>(low_product) >> 62);
  bool negative = std::signbit(x);
  double sign = negative ? -1 : 1;
  quadrant *= sign;
  if ((fraction >> 127) != 0) {
    fraction = Wide(0) - fraction;
    quadrant += sign;
    sign = -sign;
  }
  if (fraction == 0) return {quadrant, 0, 0};
  int shift = 0;
  while ((fraction >> 127) == 0) {
    fraction <<= 1;
    ++shift;
  }
  const double high = static_cast<double>(static_cast<std::uint64_t>(fraction >> 75)) * std::ldexp(1.0, -53 - shift);
  const double low = static_cast<double>(static_cast<std::uint64_t>((fraction >> 22) & 0x1fffffffffffff)) *
                     std::ldexp(1.0, -106 - shift);
  const auto product = lanes::exact_product(one_lane, lane(high), lane(pi_high / 2));
  const double tail = number(product.low) + (high * (pi_low / 2) + low * (pi_high / 2));
  const double angle = number(product.high) + tail;
  return {quadrant, sign * angle, sign * (tail - (angle - number(product.high)))};
}

SineCosine sincos(double x) {
  const auto result = lanes::sincos_of(one_lane, lane(x));
  return {number(result.sine), number(result.cosine)};
}

SineCosine sincos_turns(double turns) {
  if (!std::isfinite(turns)) return {not_a_number, not_a_number};
  const double part = turns - std::floor(turns);
  const double quadrant = std::floor(4 * part + 0.5);
  const double rest = part - quadrant / 4;
  const auto product = lanes::exact_product(one_lane, lane(rest), lane(2 * pi_high));
  const double low = number(product.low) + rest * (2 * pi_low);
  const auto result = lanes::sincos_of_reduced(one_lane, lane(quadrant), product.high, lane(low));
  return {number(result.sine), number(result.cosine)};
}

double sin(double x) { return x == 0 ? x : sincos(x).sine; }
double cos(double x) { return sincos(x).cosine; }
double tan(double x) {
  const SineCosine value = sincos(x);
  return x == 0 ? x : value.sine / value.cosine;
}

double atan(double x) {
  const double a = std::abs(x);
  if (std::isnan(x)) return x;
  double result = 0;
  if (a < 0.4375) {
    result = a - arctangent_polynomial(a);
  } else if (a < 0.6875) {
    const double r = (2 * a - 1) / (2 + a);
    result = 4.63647609000806093515e-01 - ((arctangent_polynomial(r) - 2.26987774529616870924e-17) - r);
  } else if (a < 1.1875) {
    const double r = (a - 1) / (a + 1);
    result = 7.85398163397448278999e-01 - ((arctangent_polynomial(r) - 3.06161699786838301793e-17) - r);
  } else if (a < 2.4375) {
    const double r = (a - 1.5) / (1 + 1.5 * a);
    result = 9.82793723247329054082e-01 - ((arctangent_polynomial(r) - 1.39033110312309984516e-17) - r);
  } else {
    const double r = -1 / a;
    result = 1.57079632679489655800e+00 - ((arctangent_polynomial(r) - 6.12323399573676603587e-17) - r);
  }
  return std::copysign(result, x);
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return not_a_number;
  const double a = std::abs(y), b = std::abs(x);
  double angle = 0;  // of (b, a), in the first quadrant
  if (a == infinity && b == infinity) {
    angle = pi_high / 4;
  } else if (a != 0) {
    angle = b == 0 ? pi_high / 2 : atan(a / b);
  }
  if (std::signbit(x)) angle = pi_high - (angle - pi_low);
  return std::copysign(angle, y);
}

double asin(double x) { return std::abs(x) <= 1 ? atan2(x, std::sqrt((1 - x) * (1 + x))) : not_a_number; }
double acos(double x) { return std::abs(x) <= 1 ? atan2(std::sqrt((1 - x) * (1 + x)), x) : not_a_number; }

double sinh(double x) {
  const double a = std::abs(x);
  if (!(a <= infinity)) return x;
  double result = 0;
  if (a < 22) {
    const double t = number(lanes::exponential_minus_one(one_lane, lane(a)));
    result = a < 1 ? 0.5 * (2 * t - t * t / (t + 1)) : 0.5 * (t + t / (t + 1));
  } else {
    const double half = exp(0.5 * a);
    result = 0.5 * half * half;
  }
  return std::copysign(result, x);
}

double cosh(double x) {
  const double a = std::abs(x);
  if (a < 22) {
    const double t = exp(a);
    return 0.5 * t + 0.5 / t;
  }
  const double half = exp(0.5 * a);
  return 0.5 * half * half;
}

double tanh(double x) { return std::isnan(x) ? x : number(lanes::tanh_of(one_lane, lane(x))); }

double asinh(double x) {
  const double a = std::abs(x);
  if (!(a < infinity)) return x;
  const double result =
      a > 0x1p28 ? log(a) + 6.93147180559945286227e-01 : log_one_plus(a + a * a / (1 + std::sqrt(1 + a * a)));
  return std::copysign(result, x);
}

double acosh(double x) {
  if (!(x >= 1)) return not_a_number;
  if (x > 0x1p28) return log(x) + 6.93147180559945286227e-01;
  const double t = x - 1;
  return log_one_plus(t + std::sqrt(2 * t + t * t));
}

double atanh(double x) {
  const double a = std::abs(x);
  if (!(a <= 1)) return not_a_number;
  return std::copysign(a == 1 ? infinity : 0.5 * log_one_plus(2 * a / (1 - a)), x);
}

double cbrt(double x) {
  const double a = std::abs(x);
  if (a == 0 || !(a < infinity)) return x;
  int exponent = 0;
  const double fraction = std::frexp(a, &exponent);
  const int third = (exponent + 3000) / 3 - 1000;
  const double scaled = std::ldexp(fraction, exponent - 3 * third);
  const double guess = number(lanes::power_of(one_lane, lane(scaled), lane(1.0 / 3)));
  const double root = guess - (guess * guess * guess - scaled) / (3 * guess * guess);
  return std::copysign(std::ldexp(root, third), x);
}

double hypot(double x, double y) {
  if (std::isinf(x) || std::isinf(y)) return infinity;
  const double largest = std::abs(x) > std::abs(y) ? std::abs(x) : std::abs(y);
  if (!(largest > 0)) return std::isnan(x) || std::isnan(y) ? not_a_number : 0;
  const int exponent = std::ilogb(largest);
  const double a = std::ldexp(x, -exponent), b = std::ldexp(y, -exponent);
  return std::ldexp(std::sqrt(a * a + b * b), exponent);
}

}  // namespace dini::elementary

#pragma once

// Elementary functions that give the same bits on every machine: only IEEE + - * /, square roots and bit operations.
//
// The platform's mathematics library picks fused variants by processor, so it is not used anywhere in the algebra. The
// SIMD kernels run the same code as these functions (algebra/elementary-inl.h). Errors stay within about 2 units in the
// last place (pow, whose results near the ends of the range lose a few more). Domain errors give NaN, poles and
// overflow give infinities; finite input inside the domain never gives NaN.

namespace dini::elementary {

double exp(double x);
double log(double x);
double log2(double x);
double log10(double x);
/// x to the power y, with the special cases of IEEE 754: pow(x, 0) = 1, negative bases for integer powers only.
double pow(double x, double y);

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};
/// Both at once, radians, any finite argument (exact reduction).
SineCosine sincos(double x);
/// Both at once for an angle in turns; multiples of a quarter turn are exact.
SineCosine sincos_turns(double turns);
double sin(double x);
double cos(double x);
double tan(double x);
double asin(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);

double sinh(double x);
double cosh(double x);
double tanh(double x);
double asinh(double x);
double acosh(double x);
double atanh(double x);

double cbrt(double x);
double hypot(double x, double y);

/// x = quadrant * pi/2 + high + low with |high| <= pi/4, for large finite x (Payne and Hanek 1983); quadrant modulo 4.
struct ReducedAngle {
  double quadrant = 0;
  double high = 0;
  double low = 0;
};
ReducedAngle reduce_large_angle(double x);

}  // namespace dini::elementary

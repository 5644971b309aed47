#pragma once

// Batch kernels over columns of points, double precision, dispatched at run time to the widest instruction set of the
// processor (Highway). No fused multiply-add and no platform mathematics inside: every instruction set gives the same
// bits.
//
// All arrays are component arrays of the same `count`; outputs may equal inputs. A point whose image is at infinity
// gets +infinity in all three coordinates. No kernel produces NaN from finite input.

#include <cstddef>
#include <span>

#include "algebra/elements.h"

namespace dini::kernels {

/// Component arrays of a column of points.
struct ConstPoints {
  const double* x;
  const double* y;
  const double* z;
};
struct Points {
  double* x;
  double* y;
  double* z;
};

/// One value per point, or one value for all of them (`constant`).
struct ConstNumbers {
  const double* values;
  bool constant;
};

/// Component arrays of a column of generators in the order of Components<Generator>, or one generator for all.
struct ConstGenerators {
  const double* components[10];
  bool constant;
};

/// exp(amounts[i] T(position, tangent)) on every point: p -> c + (y + a y^2) / (1 + 2 a.y + a^2 y^2), a = amount *
/// tangent.
void boost_points(const Point& position, const Vector& tangent, ConstNumbers amounts, ConstPoints in, Points out,
                  std::size_t count);

/// One versor on every point.
void transform_points(const Versor& versor, ConstPoints in, Points out, std::size_t count);

/// exp(amounts[i] generators[i]) on point i, by either rule.
void transform_points(ConstGenerators generators, ConstNumbers amounts, Rule rule, ConstPoints in, Points out,
                      std::size_t count);

/// Blends four generators bilinearly, B = (1-u)(1-v) a + u(1-v) b + (1-u) v c + u v d, and applies exp(amounts[i] B).
struct BilinearCorners {
  Generator a, b, c, d;
};
void transform_points_bilinear(const BilinearCorners& corners, ConstNumbers u, ConstNumbers v, ConstNumbers amounts,
                               Rule rule, ConstPoints in, Points out, std::size_t count);

/// How generators act together in a warp.
enum class WarpMethod { sum_generators, sum_displacements };

/// One generator of a warp with the position its distance is measured from. Null pairs at their position are the fast
/// case; any other generator works too.
struct WarpSource {
  Generator generator;
  Point position;
};

/// A generator with its own position: of a pair its middle (a null pair's place), of a flat point that point, of a dual
/// line its point nearest the origin, otherwise the origin.
WarpSource warp_source(const Generator& generator);

/// Whether anybody still wants the result of a kernel that may take long for one element; never asked by default.
class Stop {
 public:
  Stop() = default;
  Stop(const void* owner, bool (*asked)(const void* owner)) : owner_(owner), asked_(asked) {}

  bool operator()() const { return asked_ != nullptr && asked_(owner_); }

 private:
  const void* owner_ = nullptr;
  bool (*asked_)(const void* owner) = nullptr;
};

/// The generators of a warp, looked at once for all points that they move. `sources` must outlive it. A stopped one
/// means nothing.
class WarpField {
 public:
  explicit WarpField(std::span<const WarpSource> sources, Stop stop = {});

  std::span<const WarpSource> sources() const { return sources_; }
  bool null_pairs_only() const { return null_pairs_only_; }
  const Vector& sum_of_tangents() const { return sum_of_tangents_; }

 private:
  std::span<const WarpSource> sources_;
  bool null_pairs_only_ = true;
  Vector sum_of_tangents_;
};

/// The paper's eqs. (13), (16): weight 1 / (d^power + softening) per generator, rotor exp(strength * weighted sum),
/// center. At a generator (d = 0 with softening 0) the limit is used: the point stays where it is.
struct WarpSettings {
  double strength = 1;
  double power = 2;
  double softening = 0;
  Rule rule = Rule::exact;
  WarpMethod method = WarpMethod::sum_generators;
};
/// Asks `stop` about once a millisecond, also within the sum for one point; what is left then stays as it was.
void warp_points(const WarpField& field, const WarpSettings& settings, ConstPoints in, Points out, std::size_t count,
                 Stop stop = {});

/// Names of the instruction sets this program can run here, best first, and a way to force one (tests, benchmarks).
std::span<const char* const> instruction_sets();
bool force_instruction_set(const char* name);  ///< "" restores the choice by processor; false when not available.
const char* current_instruction_set();

}  // namespace dini::kernels

#pragma once

// Seeded random elements, the same on every machine (no distributions of the standard library).

#include <cstdint>

#include "algebra/construct.h"

namespace dini {

class RandomElements {
 public:
  explicit RandomElements(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 1) {}

  /// Uniform in [-scale, scale).
  double number(double scale = 1) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return scale * (static_cast<double>(state_ >> 11) * 0x1p-52 - 1);
  }
  Vector vector(double scale = 1) { return {number(scale), number(scale), number(scale)}; }
  Point point(double scale = 1) { return to_point(vector(scale)); }
  Generator generator(double scale = 1) { return {vector(scale), vector(scale), number(scale), vector(scale)}; }
  Generator pair(double scale = 1) { return null_pair(point(), vector(scale)); }
  Versor versor() { return {number(), generator(), {number(), vector(), number()}}; }

 private:
  std::uint64_t state_;
};

}  // namespace dini

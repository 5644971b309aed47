#pragma once

#include "golden/shape.h"

namespace dini {

/// A point on a model, with the normal of its triangle (zero on curves and points) and the color there.
struct Sample {
  Vector position;
  Vector normal;
  std::array<float, 4> color = {};
};

/// A few hundred points on a model, evenly by area, by length along curves, by number among points. Equal shapes give
/// equal samples.
std::vector<Sample> samples_of(const Shape& shape);

/// How far the farthest point of the model is from the nearest of these.
double spacing_of(const Shape& shape, const std::vector<Sample>& samples);

/// The corner of a model that is farthest from all samples, and how far.
struct Farthest {
  Vector position;
  double distance = 0;
};
Farthest farthest_from(const Shape& shape, const std::vector<Sample>& samples);

}  // namespace dini

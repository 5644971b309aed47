#include "golden/samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace dini {
namespace {

/// Of triangles, of segments, and of points.
constexpr std::array<std::size_t, 3> most_samples = {256, 64, 64};

Vector corner(const Shape& shape, const Shape::Piece& piece, std::size_t index) { return shape.points[piece[index]]; }

Vector twice_area(const Shape& shape, const Shape::Piece& piece) {
  const Vector a = corner(shape, piece, 0);
  return cross(corner(shape, piece, 1) - a, corner(shape, piece, 2) - a);
}

double size_of(const Shape& shape, const Shape::Piece& piece, std::size_t kind) {
  if (kind == 0) return length(twice_area(shape, piece));
  return kind == 1 ? length(corner(shape, piece, 1) - corner(shape, piece, 0)) : 1;
}

/// A point of a piece by two numbers of [0, 1): folded into a triangle, along a segment.
Sample sample_at(const Shape& shape, const Shape::Piece& piece, double u, double v, std::size_t kind) {
  if (kind > 0) v = 0;
  if (kind == 0 && u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const std::array<double, 3> weights = {1 - u - v, u, v};
  Sample sample{};
  for (std::size_t k = 0; k < weights.size(); ++k) {
    sample.position = sample.position + weights[k] * corner(shape, piece, k);
    for (std::size_t c = 0; c < sample.color.size(); ++c) {
      sample.color[c] += static_cast<float>(weights[k]) * shape.colors[piece[k]][c];
    }
  }
  const Vector normal = twice_area(shape, piece);
  if (const double size = length(normal); kind == 0 && size > 0) sample.normal = (1 / size) * normal;
  return sample;
}

void add_samples(const Shape& shape, std::span<const Shape::Piece> pieces, std::size_t kind,
                 std::vector<Sample>& samples) {
  std::vector<double> until;
  double total = 0;
  for (const Shape::Piece& piece : pieces) until.push_back(total += size_of(shape, piece, kind));
  if (!(total > 0)) return;
  const std::size_t count = kind == 2 ? std::min(most_samples[kind], pieces.size()) : most_samples[kind];
  // Two irrational steps that fill the square evenly (the plastic number and its square).
  constexpr double step_u = 0.7548776662466927, step_v = 0.5698402909980532;
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = total * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const auto found = std::ranges::upper_bound(until, wanted);
    const auto index = std::min(static_cast<std::size_t>(found - until.begin()), pieces.size() - 1);
    double whole = 0;
    const double n = static_cast<double>(i) + 1;
    samples.push_back(
        sample_at(shape, pieces[index], std::modf(n * step_u, &whole), std::modf(n * step_v, &whole), kind));
  }
}

}  // namespace

std::vector<Sample> samples_of(const Shape& shape) {
  std::vector<Sample> samples;
  const std::span<const Shape::Piece> all(shape.pieces);
  add_samples(shape, all.first(shape.triangles), 0, samples);
  add_samples(shape, all.subspan(shape.triangles, shape.segments), 1, samples);
  add_samples(shape, all.subspan(shape.triangles + shape.segments), 2, samples);
  return samples;
}

Farthest farthest_from(const Shape& shape, const std::vector<Sample>& samples) {
  Farthest farthest;
  if (samples.empty()) return farthest;
  double most = -1;
  for (const Vector& point : shape.points) {
    double least = std::numeric_limits<double>::infinity();
    for (const Sample& sample : samples) {
      const Vector apart = point - sample.position;
      least = std::min(least, dot(apart, apart));
      if (least <= most) break;  // it is not the farthest one
    }
    if (least > most) {
      most = least;
      farthest = {point, std::sqrt(least)};
    }
  }
  return farthest;
}

double spacing_of(const Shape& shape, const std::vector<Sample>& samples) {
  return farthest_from(shape, samples).distance;
}

}  // namespace dini

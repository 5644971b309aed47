#include "golden/nearest_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dini {
namespace {

using Corners = std::array<Vector, 3>;

constexpr std::size_t pieces_in_box = 64;

/// Weights of the corners at the nearest point of a segment.
std::array<double, 3> on_segment(const Corners& corners, std::size_t from, std::size_t to, const Vector& point) {
  const Vector along = corners[to] - corners[from];
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(point - corners[from], along) / square, 0.0, 1.0) : 0;
  std::array<double, 3> weights = {};
  weights[from] = 1 - share;
  weights[to] += share;
  return weights;
}

Vector at(const Corners& corners, const std::array<double, 3>& weights) {
  return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
}

double squared_distance(const Vector& a, const Vector& b) { return dot(a - b, a - b); }

/// Weights of the corners at the nearest point of a triangle: its foot if that is inside, else the best of the edges.
std::array<double, 3> nearest_weights(const Corners& corners, const Vector& point) {
  const Vector u = corners[1] - corners[0], v = corners[2] - corners[0], w = point - corners[0];
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const double denominator = uu * vv - uv * uv;
  if (denominator > 0) {
    const double s = (wu * vv - wv * uv) / denominator, t = (wv * uu - wu * uv) / denominator;
    if (s >= 0 && t >= 0 && s + t <= 1) return {1 - s - t, s, t};
  }
  std::array<double, 3> best = on_segment(corners, 0, 1, point);
  for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{1, 2}, {2, 0}}) {
    const std::array<double, 3> weights = on_segment(corners, from, to, point);
    if (squared_distance(at(corners, weights), point) < squared_distance(at(corners, best), point)) best = weights;
  }
  return best;
}

/// The squared distance to a box: nothing in it is nearer.
double least_squared_distance(const Vector& low, const Vector& high, const Vector& point) {
  const auto outside = [](double value, double least, double most) {
    return value < least ? least - value : std::max(value - most, 0.0);
  };
  return squared_length(
      {outside(point.x, low.x, high.x), outside(point.y, low.y, high.y), outside(point.z, low.z, high.z)});
}

double cosine(const Corners& corners, const Vector& normal) {
  const Vector own = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double size = length(own);
  return size > 0 ? dot(own, normal) / size : -1;
}

std::array<float, 4> color_at(const Shape& shape, const Shape::Piece& piece, const std::array<double, 3>& weights) {
  std::array<float, 4> color = {};
  for (std::size_t k = 0; k < weights.size(); ++k) {
    for (std::size_t c = 0; c < color.size(); ++c) {
      color[c] += static_cast<float>(weights[k]) * shape.colors[piece[k]][c];
    }
  }
  return color;
}

double largest_difference(const std::array<float, 4>& a, const std::array<float, 4>& b) {
  double largest = 0;
  for (std::size_t c = 0; c < a.size(); ++c) largest = std::max(largest, static_cast<double>(std::abs(a[c] - b[c])));
  return largest;
}

}  // namespace

NearestPlaces::NearestPlaces(const Shape& shape) : shape_(shape) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t begin = 0; begin < shape.pieces.size(); begin += pieces_in_box) {
    Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    const std::size_t end = std::min(begin + pieces_in_box, shape.pieces.size());
    for (std::size_t i = begin; i < end; ++i) {
      for (const std::uint32_t corner : shape.pieces[i]) {
        const Vector& point = shape.points[corner];
        box.low = {std::min(box.low.x, point.x), std::min(box.low.y, point.y), std::min(box.low.z, point.z)};
        box.high = {std::max(box.high.x, point.x), std::max(box.high.y, point.y), std::max(box.high.z, point.z)};
      }
    }
    boxes_.push_back(box);
  }
}

NearestPlace NearestPlaces::to(const Sample& sample, double tie) const {
  NearestPlace nearest{.distance = std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < shape_.pieces.size(); ++i) {
    const double reach = nearest.distance + tie;
    if (i % pieces_in_box == 0) {
      const Box& box = boxes_[i / pieces_in_box];
      if (least_squared_distance(box.low, box.high, sample.position) > reach * reach) {
        i += pieces_in_box - 1;
        continue;
      }
    }
    const Shape::Piece& piece = shape_.pieces[i];
    const Corners corners = {shape_.points[piece[0]], shape_.points[piece[1]], shape_.points[piece[2]]};
    const std::array<double, 3> weights = nearest_weights(corners, sample.position);
    const double distance = std::sqrt(squared_distance(at(corners, weights), sample.position));
    if (distance > reach) continue;
    if (distance < nearest.distance - tie) nearest = {.distance = distance};
    nearest.distance = std::min(nearest.distance, distance);
    nearest.turned = std::max(nearest.turned, cosine(corners, sample.normal));
    const std::array<float, 4> color = color_at(shape_, piece, weights);
    if (const double recolored = largest_difference(color, sample.color); recolored < nearest.recolored) {
      nearest.recolored = recolored;
      nearest.color = color;
    }
  }
  return nearest;
}

}  // namespace dini

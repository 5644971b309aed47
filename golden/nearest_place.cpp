#include "golden/nearest_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/mesh_tree.h"

namespace dini {
namespace {

using Corners = std::array<Vector, 3>;

constexpr std::size_t pieces_in_box = 64;

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
  for (std::size_t begin = 0; begin < shape.pieces.size(); begin += pieces_in_box) {
    BoundingBox box;
    const std::size_t end = std::min(begin + pieces_in_box, shape.pieces.size());
    for (std::size_t i = begin; i < end; ++i) {
      for (const std::uint32_t corner : shape.pieces[i]) box.add(shape.points[corner]);
    }
    boxes_.push_back(box);
  }
}

NearestPlace NearestPlaces::to(const Sample& sample, double tie) const {
  NearestPlace nearest{.distance = std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < shape_.pieces.size(); ++i) {
    const double reach = nearest.distance + tie;
    if (i % pieces_in_box == 0) {
      if (boxes_[i / pieces_in_box].squared_distance(sample.position) > reach * reach) {
        i += pieces_in_box - 1;
        continue;
      }
    }
    const Shape::Piece& piece = shape_.pieces[i];
    const Corners corners = {shape_.points[piece[0]], shape_.points[piece[1]], shape_.points[piece[2]]};
    const MeshPlace place = nearest_on_triangle(corners, sample.position);
    const double distance = std::sqrt(place.squared_distance);
    if (distance > reach) continue;
    if (distance < nearest.distance - tie) nearest = {.distance = distance};
    nearest.distance = std::min(nearest.distance, distance);
    nearest.turned = std::max(nearest.turned, cosine(corners, sample.normal));
    const std::array<float, 4> color = color_at(shape_, piece, place.weights);
    if (const double recolored = largest_difference(color, sample.color); recolored < nearest.recolored) {
      nearest.recolored = recolored;
      nearest.color = color;
    }
  }
  return nearest;
}

}  // namespace dini

#include "geometry/mesh_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace dini {
namespace {

constexpr std::uint32_t triangles_in_leaf = 4;

MeshPlace place_of(const std::array<Vector, 3>& corners, const std::array<double, 3>& weights, const Vector& point) {
  const Vector position = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
  return {0, weights, position, squared_length(point - position)};
}

MeshPlace nearest_on_segment(const std::array<Vector, 3>& corners, std::size_t from, std::size_t to,
                             const Vector& point) {
  const Vector along = corners[to] - corners[from];
  const double square = squared_length(along);
  const double share = square > 0 ? std::clamp(dot(point - corners[from], along) / square, 0.0, 1.0) : 0;
  std::array<double, 3> weights = {};
  weights[from] = 1 - share;
  weights[to] = share;
  return place_of(corners, weights, point);
}

double coordinate(const Vector& vector, int axis) { return axis == 0 ? vector.x : axis == 1 ? vector.y : vector.z; }

}  // namespace

MeshPlace nearest_on_triangle(const std::array<Vector, 3>& corners, const Vector& point) {
  const Vector u = corners[1] - corners[0], v = corners[2] - corners[0], w = point - corners[0];
  const double uu = squared_length(u), uv = dot(u, v), vv = squared_length(v), wu = dot(w, u), wv = dot(w, v);
  const double determinant = uu * vv - uv * uv;
  // Of a sliver the foot is round-off, and its edges are as near.
  if (determinant > 1e-12 * uu * vv) {
    const double s = (wu * vv - wv * uv) / determinant, t = (wv * uu - wu * uv) / determinant;
    if (s >= 0 && t >= 0 && s + t <= 1) return place_of(corners, {1 - s - t, s, t}, point);
  }
  // The foot is outside, so the nearest place is on an edge.
  MeshPlace best = nearest_on_segment(corners, 0, 1, point);
  for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{1, 2}, {2, 0}}) {
    const MeshPlace place = nearest_on_segment(corners, from, to, point);
    if (place.squared_distance < best.squared_distance) best = place;
  }
  return best;
}

MeshTree::MeshTree(std::vector<Vector> positions, Triangles triangles, const Cancel& cancel)
    : positions_(std::move(positions)), triangles_(std::move(triangles)), order_(triangles_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  std::vector<Vector> middles(triangles_.size());
  CancelEvery steps(cancel);
  for (std::size_t i = 0; i < triangles_.size() && !steps.stopped(); ++i) {
    const auto [a, b, c] = corners(i);
    middles[i] = a + b + c;
  }
  // A box that is still to be divided, and the one whose right child it is.
  struct Open {
    std::uint32_t begin, end;
    std::uint32_t parent;
    bool is_right;
  };
  std::vector<Open> open = {{0, static_cast<std::uint32_t>(order_.size()), 0, false}};
  while (!open.empty() && !cancel.stopped()) {
    const Open now = open.back();
    open.pop_back();
    const auto index = static_cast<std::uint32_t>(boxes_.size());
    if (now.is_right) boxes_[now.parent].right = index;
    boxes_.push_back(box_around(now.begin, now.end));
    if (now.end - now.begin <= triangles_in_leaf) continue;
    const Vector size = boxes_[index].bounds.high - boxes_[index].bounds.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = now.begin + (now.end - now.begin) / 2;
    std::nth_element(order_.begin() + now.begin, order_.begin() + middle, order_.begin() + now.end,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double left = coordinate(middles[a], axis), right = coordinate(middles[b], axis);
                       return left < right || (left == right && a < b);
                     });
    open.push_back({middle, now.end, index, true});
    open.push_back({now.begin, middle, index, false});
  }
}

MeshPlace MeshTree::nearest(const Vector& point) const {
  MeshPlace best;
  best.squared_distance = std::numeric_limits<double>::infinity();
  const auto reach = [&](std::uint32_t index) { return boxes_[index].bounds.squared_distance(point); };
  std::array<std::pair<std::uint32_t, double>, most_open> open;
  std::size_t count = 0;
  if (!boxes_.empty()) open[count++] = {0, 0};
  while (count > 0) {
    const auto [index, distance] = open[--count];
    if (distance >= best.squared_distance) continue;
    const Box& box = boxes_[index];
    if (box.right == 0) {
      for (std::uint32_t i = box.begin; i < box.end; ++i) {
        MeshPlace place = nearest_on_triangle(corners(order_[i]), point);
        place.triangle = order_[i];
        if (place.squared_distance < best.squared_distance) best = place;
      }
      continue;
    }
    std::pair<std::uint32_t, double> near{index + 1, reach(index + 1)}, far{box.right, reach(box.right)};
    if (far.second < near.second) std::swap(near, far);
    open[count++] = far;
    open[count++] = near;
  }
  return best;
}

std::size_t MeshTree::bytes() const {
  return sizeof(Vector) * positions_.size() + (sizeof(triangles_[0]) + sizeof(order_[0])) * triangles_.size() +
         sizeof(Box) * boxes_.size();
}

Vector MeshTree::normal(std::size_t triangle) const {
  const auto [a, b, c] = corners(triangle);
  return normalized(cross(b - a, c - a));
}

std::array<Vector, 3> MeshTree::corners(std::size_t triangle) const {
  const auto& [a, b, c] = triangles_[triangle];
  return {positions_[a], positions_[b], positions_[c]};
}

MeshTree::Box MeshTree::box_around(std::uint32_t begin, std::uint32_t end) const {
  Box box{{}, begin, end};
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const Vector& point : corners(order_[i])) box.bounds.add(point);
  }
  return box;
}

}  // namespace dini

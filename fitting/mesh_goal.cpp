#include "fitting/mesh_goal.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>

#include "geometry/bounding_box.h"

namespace dini::fitting {
namespace {

constexpr std::size_t most_samples = 4000;
/// In proportion to the size of the mesh: from here on a place counts as one on the surface, whose distance grows along
/// the normal.
constexpr double on_surface = 1e-9;

/// Some of the vertices that triangles use, evenly among them.
std::vector<std::uint32_t> samples_among(std::size_t vertices, const MeshTree::Triangles& triangles) {
  std::vector<bool> used(vertices);
  for (const auto& triangle : triangles) {
    for (const std::uint32_t corner : triangle) used[corner] = true;
  }
  std::vector<std::uint32_t> all, some;
  for (std::uint32_t i = 0; i < vertices; ++i) {
    if (used[i]) all.push_back(i);
  }
  const std::size_t count = std::min(most_samples, all.size());
  for (std::size_t k = 0; k < count; ++k) some.push_back(all[k * all.size() / count]);
  return some;
}

double diagonal_of(const Surface& surface) {
  BoundingBox bounds;
  for (const auto& triangle : surface.triangles) {
    for (const std::uint32_t corner : triangle) bounds.add(surface.positions[corner]);
  }
  const double diagonal = length(bounds.high - bounds.low);
  return diagonal > 0 ? diagonal : 1;
}

/// The direction and length of the way from a place on a surface to a point.
void set_way(Foot& foot, const Vector& way, const Vector& normal, double size) {
  const double distance = length(way);
  const bool lies_on_it = distance <= on_surface * size;
  foot.direction = lies_on_it ? normal : way / distance;
  foot.distance = lies_on_it ? dot(normal, way) : distance;
}

Vector at(const Surface& surface, const Foot& foot) {
  return foot.weights[0] * surface.positions[foot.corners[0]] + foot.weights[1] * surface.positions[foot.corners[1]] +
         foot.weights[2] * surface.positions[foot.corners[2]];
}

}  // namespace

MeshGoal::MeshGoal(Surface target, const Cancel& cancel) : tree_({}, {}, cancel) {
  samples_ = samples_among(target.positions.size(), target.triangles);
  size_ = diagonal_of(target);
  tree_ = MeshTree(std::move(target.positions), std::move(target.triangles), cancel);
}

std::vector<Foot> MeshGoal::feet_of(const Surface& model, const Cancel& cancel) const {
  const std::vector<std::uint32_t> own = samples_among(model.positions.size(), model.triangles);
  const MeshTree tree(model.positions, model.triangles, cancel);
  std::vector<Foot> feet(own.size() + samples_.size());
  tbb::parallel_for(std::size_t{0}, feet.size(), [&](std::size_t i) {
    if (cancel.stopped()) return;
    Foot& foot = feet[i];
    if (i < own.size()) {
      const Vector& point = model.positions[own[i]];
      const MeshPlace place = tree_.nearest(point);
      foot.corners = {own[i], own[i], own[i]};
      foot.weights = {1, 0, 0};
      set_way(foot, point - place.position, tree_.normal(place.triangle), size_);
    } else {
      const Vector& point = tree_.positions()[samples_[i - own.size()]];
      const MeshPlace place = tree.nearest(point);
      foot.corners = model.triangles[place.triangle];
      foot.weights = place.weights;
      set_way(foot, place.position - point, tree.normal(place.triangle), size_);
    }
  });
  return feet;
}

double MeshGoal::weight(std::size_t samples) const {
  return 1 / (size_ * std::sqrt(2 * static_cast<double>(std::max<std::size_t>(1, samples))));
}

std::vector<double> MeshGoal::residuals(const std::vector<Foot>& feet) const {
  const std::size_t own = samples_of_model(feet);
  std::vector<double> values(feet.size());
  for (std::size_t i = 0; i < feet.size(); ++i) {
    values[i] = weight(i < own ? own : samples_.size()) * feet[i].distance;
  }
  return values;
}

std::vector<double> MeshGoal::slopes(const std::vector<Foot>& feet, const Surface& model, const Surface& moved,
                                     double step) const {
  const std::size_t own = samples_of_model(feet);
  std::vector<double> values(feet.size());
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const Vector motion = (at(moved, feet[i]) - at(model, feet[i])) / step;
    values[i] = weight(i < own ? own : samples_.size()) * dot(feet[i].direction, motion);
  }
  return values;
}

MeshDistance MeshGoal::distance(const std::vector<Foot>& feet) const {
  MeshDistance distance;
  for (const double residual : residuals(feet)) distance.root_mean_square += residual * residual;
  distance.root_mean_square = size_ * std::sqrt(distance.root_mean_square);
  for (const Foot& foot : feet) distance.largest = std::max(distance.largest, std::abs(foot.distance));
  return distance;
}

}  // namespace dini::fitting

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/mesh_tree.h"

namespace dini::fitting {

/// The triangles of one or several meshes as one.
struct Surface {
  std::vector<Vector> positions;
  MeshTree::Triangles triangles;
};

/// How far a model is from the mesh that it is to be like, in meters, both ways together.
struct MeshDistance {
  double root_mean_square = 0;
  double largest = 0;
};

/// One distance: where it begins on the model, and along which direction it grows.
struct Foot {
  std::array<std::uint32_t, 3> corners = {};  ///< vertices of the model
  std::array<double, 3> weights = {};
  Vector direction;  ///< by which the distance grows when the model moves along it: of length 1, or zero
  double distance = 0;
};

/// A mesh to be like. Distances are taken from some thousand vertices of the model to the nearest places of the mesh,
/// and from as many vertices of the mesh to the nearest places of the model.
class MeshGoal {
 public:
  /// A mesh of at least one triangle. Stopped early: meaningless.
  MeshGoal(Surface target, const Cancel& cancel);

  /// All distances of a model of at least one triangle. Equal numbers of vertices and triangles give as many feet.
  std::vector<Foot> feet_of(const Surface& model, const Cancel& cancel) const;

  /// What the distances of one model are as the members of a sum of squares: half of the mean square in each direction,
  /// in proportion to the size of the mesh.
  std::vector<double> residuals(const std::vector<Foot>& feet) const;

  /// How fast these grow when the model with those feet moves to `moved`, whose vertices are the same ones, in a step
  /// of that length: the nearest place itself may be taken as fixed, since moving it changes no distance to first
  /// order.
  std::vector<double> slopes(const std::vector<Foot>& feet, const Surface& model, const Surface& moved,
                             double step) const;

  MeshDistance distance(const std::vector<Foot>& feet) const;

  /// About how much memory it holds.
  std::size_t bytes() const { return tree_.bytes(); }

 private:
  std::size_t samples_of_model(const std::vector<Foot>& feet) const { return feet.size() - samples_.size(); }
  double weight(std::size_t samples) const;

  MeshTree tree_;
  std::vector<std::uint32_t> samples_;  ///< vertices of the mesh
  double size_ = 1;                     ///< the diagonal of its bounds
};

}  // namespace dini::fitting

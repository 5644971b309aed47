#include "geometry/contacts.h"

#include <algorithm>
#include <cmath>

#include "geometry/bounding_box.h"
#include "geometry/chunks.h"
#include "geometry/clip.h"
#include "geometry/extremes.h"
#include "geometry/mesh_tree.h"
#include "geometry/triangle_pair.h"

namespace dini {

namespace {

constexpr std::size_t triangles_at_once = 256;

/// The positions in units of a power of two that makes the largest coordinate about 1; what is then below 1e-60 is
/// zero.
std::vector<Vector> unit_scaled(const std::vector<Vector>& positions, CancelEvery& steps) {
  double largest = 0;
  for (std::size_t i = 0; i < positions.size() && !steps.stopped(); ++i) {
    largest = std::max(largest, largest_component(positions[i]));
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  const auto taken = [exponent](double value) {
    const double small = std::ldexp(value, -exponent);
    return std::abs(small) < 1e-60 ? 0.0 : small;
  };
  std::vector<Vector> result(positions.size());
  for (std::size_t i = 0; i < positions.size() && !steps.stopped(); ++i) {
    result[i] = {taken(positions[i].x), taken(positions[i].y), taken(positions[i].z)};
  }
  return result;
}

/// Pairs of triangles of one mesh.
class Pairs {
 public:
  Pairs(const WeldedMesh& mesh, const Cancel& cancel, CancelEvery steps)
      : tree_(unit_scaled(mesh.positions, steps), mesh.triangles, cancel), axes_(mesh.triangles.size()) {
    for_chunks(cancel, axes_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) axes_[i] = axis_of_area(corners(i).places);
    });
  }

  /// Calls found() for every triangle after `i` that meets it, until that answers false.
  template <class Found>
  void for_each_of(std::size_t i, CancelEvery& steps, const Found& found) const {
    const PairCorners own = corners(i);
    if (own.axis < 0) return;
    const BoundingBox box = box_of(own.places);
    tree_.visit_near(box, [&](std::uint32_t other) {
      if (steps.stopped()) return false;
      if (other <= i) return true;
      const PairCorners theirs = corners(other);
      if (theirs.axis < 0 || !box.meets(box_of(theirs.places)) || !triangles_meet(own, theirs)) return true;
      return found();
    });
  }

  std::size_t size() const { return axes_.size(); }

 private:
  PairCorners corners(std::size_t triangle) const {
    const Corners& vertices = tree_.triangles()[triangle];
    const auto& positions = tree_.positions();
    return {vertices, {positions[vertices[0]], positions[vertices[1]], positions[vertices[2]]}, axes_[triangle]};
  }

  static BoundingBox box_of(const std::array<Vector, 3>& places) {
    BoundingBox box;
    for (const Vector& place : places) box.add(place);
    return box;
  }

  MeshTree tree_;
  std::vector<int> axes_;
};

}  // namespace

Contacts contacts_of(const WeldedMesh& mesh, std::size_t most, const Cancel& cancel) {
  if (mesh.triangles.empty() || most == 0 || cancel.stopped()) return {};
  const Pairs pairs(mesh, cancel, CancelEvery(cancel));
  std::atomic<std::size_t> count = 0, first = pairs.size();
  for_chunks(cancel, pairs.size(), triangles_at_once, [&](std::size_t begin, std::size_t end) {
    CancelEvery steps(cancel);
    for (std::size_t i = begin; i < end; ++i) {
      // Once there are enough, only lower triangles matter, for the place.
      if (count.load(std::memory_order_relaxed) >= most && i >= first.load(std::memory_order_relaxed)) return;
      pairs.for_each_of(i, steps, [&] {
        lower_to(first, i);
        return ++count < most;
      });
    }
  });
  Contacts result{std::min<std::size_t>(count, most), std::nullopt};
  if (first < pairs.size()) {
    const auto& [a, b, c] = mesh.triangles[first];
    result.place = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
  }
  return result;
}

}  // namespace dini

#include "geometry/mirror.h"

#include <algorithm>
#include <optional>

#include "algebra/extract.h"
#include "algebra/reflection.h"
#include "geometry/chunks.h"
#include "geometry/tile_ends.h"

namespace dini {

namespace {

constexpr double ridge_sine = 0.5;  ///< of 30 degrees

/// A plane or a sphere, with what is near it.
class MirrorFace {
 public:
  explicit MirrorFace(const Sphere& mirror) : at_(*coordinates(mirror)) {}

  /// Signed, along the direction that `upright` gives.
  double distance(const Vector& place) const {
    return at_.plane ? dot(at_.normal, place) - at_.distance : length(place - to_vector(at_.center)) - at_.radius;
  }
  Vector upright(const Vector& place) const {
    return at_.plane ? at_.normal : normalized(place - to_vector(at_.center));
  }

 private:
  SphereCoordinates at_;
};

/// Which vertices are on the mirror, and the mesh with these moved onto it.
struct OnMirror {
  Column<Point> positions;
  Column<Vector> normals;
  std::vector<std::uint8_t> touches;  ///< 1 on the mirror, 2 on a ridge there
  std::size_t shared = 0;             ///< vertices that both halves have
};

OnMirror moved_onto(const MirrorFace& face, const Mesh& mesh, double tolerance, const Cancel& cancel) {
  const std::size_t count = mesh.positions.size();
  OnMirror found{*mesh.positions, *mesh.normals, std::vector<std::uint8_t>(count)};
  for_chunks(cancel, count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vector place = to_vector(mesh.positions[i]);
      const double off = face.distance(place);
      if (!(std::abs(off) <= tolerance)) continue;
      const Vector up = face.upright(place);
      found.positions.set(i, to_point(place - off * up));
      found.touches[i] = 1;
      if (found.normals.empty()) continue;
      const Vector normal = mesh.normals[i];
      const double lean = dot(normal, up);
      if (std::abs(lean) > ridge_sine) {
        found.touches[i] = 2;
      } else {
        found.normals.set(i, normalized(normal - lean * up));
      }
    }
  });
  CancelEvery steps(cancel);
  for (std::size_t i = 0; i < count && !steps.stopped(); ++i) found.shared += found.touches[i] == 1 ? 1 : 0;
  return found;
}

/// The vertices of both halves: those of the mesh, and behind them the images of what is not shared.
class BothHalves {
 public:
  BothHalves(const Mesh& mesh, const OnMirror& given, const Cancel& cancel) : image_(mesh.positions.size()) {
    CancelEvery steps(cancel);
    const std::size_t count = mesh.positions.size();
    copied_.reserve(count - given.shared);
    for (std::size_t i = 0; i < count && !steps.stopped(); ++i) {
      image_[i] = static_cast<std::uint32_t>(given.touches[i] == 1 ? i : count + copied_.size());
      if (given.touches[i] != 1) copied_.push_back(static_cast<std::uint32_t>(i));
    }
  }

  std::uint32_t image_of(std::uint32_t vertex) const { return image_[vertex]; }
  /// The vertices of which there are two.
  const std::vector<std::uint32_t>& copied() const { return copied_; }

  template <class T>
  void append_copies(Shared<NumberList<T>>& items, CancelEvery& steps) const {
    if (items.empty()) return;
    NumberList<T> both = *items;
    both.reserve(both.size() + copied_.size());
    for (const std::uint32_t vertex : copied_) {
      if (steps.stopped()) return;
      both.push_back(items[vertex]);
    }
    items = std::move(both);
  }

 private:
  std::vector<std::uint32_t> image_;
  std::vector<std::uint32_t> copied_;
};

void reflect_vertices(const Sphere& mirror, const OnMirror& given, const BothHalves& halves, Mesh& whole,
                      const Cancel& cancel) {
  const std::size_t count = given.positions.size(), copies = halves.copied().size();
  Column<Point> positions(count + copies);
  Column<Vector> normals(given.normals.empty() ? 0 : count + copies);
  for_chunks(cancel, count + copies, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t i = k < count ? k : halves.copied()[k - count];
      const Point place = given.positions[i];
      const bool stays = k < count || given.touches[i] == 2;
      positions.set(k, stays ? place : reflect(mirror, place));
      if (normals.empty()) continue;
      normals.set(k, k < count ? given.normals[i] : reflected_normal(mirror, given.normals[i], place));
    }
  });
  whole.positions = std::move(positions);
  whole.normals = std::move(normals);
}

/// The triangles of the mesh and of its image, in the tiles of the mesh; none that lies in the mirror.
void reflect_triangles(const Mesh& mesh, const OnMirror& given, const BothHalves& halves, Mesh& whole,
                       CancelEvery& steps) {
  NumberList<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(2 * mesh.triangles.size());
  std::vector<std::size_t> ends;
  std::size_t tile = 0;
  for (std::size_t t = 0; t < mesh.triangles.size() && !steps.stopped(); ++t) {
    const auto& corners = mesh.triangles[t];
    const bool is_wall =
        std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) { return given.touches[corner] != 0; });
    if (!is_wall) triangles.push_back(corners);
    while (tile < mesh.tile_ends.size() && mesh.tile_ends[tile] == t + 1) {
      end_tile(ends, triangles.size());
      ++tile;
    }
  }
  const std::size_t half = triangles.size(), tiles = ends.size();
  for (std::size_t t = 0; t < half && !steps.stopped(); ++t) {
    const auto [a, b, c] = triangles[t];
    triangles.push_back({halves.image_of(a), halves.image_of(c), halves.image_of(b)});
  }
  for (std::size_t k = 0; k < tiles; ++k) ends.push_back(half + ends[k]);
  whole.triangles = std::move(triangles);
  whole.tile_ends = std::move(ends);
}

}  // namespace

Vector reflected_normal(const Sphere& mirror, const Vector& normal, const Point& place) {
  const Vector image = normalized(reflect_at(mirror, place, normal));
  return image != Vector{} ? image : normal;
}

Mesh with_mirror_image(const Mesh& mesh, const Sphere& mirror, double tolerance, const Cancel& cancel) {
  const OnMirror given = moved_onto(MirrorFace(mirror), mesh, tolerance, cancel);
  if (cancel.stopped()) return {};
  const BothHalves halves(mesh, given, cancel);
  if (cancel.stopped()) return {};
  Mesh whole = mesh;
  CancelEvery steps(cancel);
  reflect_vertices(mirror, given, halves, whole, cancel);
  reflect_triangles(mesh, given, halves, whole, steps);
  halves.append_copies(whole.uvs, steps);
  halves.append_copies(whole.colors, steps);
  return cancel.stopped() ? Mesh{} : whole;
}

}  // namespace dini

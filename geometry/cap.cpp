#include "geometry/cap.h"

#include <algorithm>

#include "geometry/dome.h"
#include "geometry/merge.h"
#include "geometry/normals.h"
#include "geometry/polygon.h"

namespace dini {

namespace {

/// Concave borders of up to so many corners are cut into ears.
constexpr std::size_t most_ears = 20'000;

/// One cap while it is made; its corners run counter-clockwise seen from outside, against the border's sides.
struct CapMesh {
  std::vector<Vector> places;
  std::vector<Corners> triangles;
  std::vector<Vector> rim_normals;  ///< of the first places; none where the rim is an edge

  std::uint32_t add(const Vector& place) {
    places.push_back(place);
    return static_cast<std::uint32_t>(places.size() - 1);
  }
};

/// A border: where its corners are, and at which vertices of the mesh.
struct Border {
  Rim rim;
  std::vector<Vector> normals;  ///< of the surface at its corners
};

/// Makes caps for the borders of one mesh.
class Caps {
 public:
  Caps(const Mesh& mesh, const WeldedMesh& welded, const Cancel& cancel)
      : mesh_(mesh), welded_(welded), vertex_at_(first_vertices(welded, cancel)) {}

  Border border(const std::vector<std::uint32_t>& loop) const {
    Border border;
    const std::size_t count = loop.size();
    for (std::size_t i = count; i-- > 0;) {
      border.rim.places.push_back(place(start_of(welded_.triangles, loop[i])));
    }
    for (std::size_t i = 0; i < count; ++i) {
      // In the order of the rim the side that begins at corner i is number count - 1 - i of the loop.
      const std::uint32_t side = loop[count - 1 - i], before = loop[(2 * count - 2 - i) % count];
      const Vector along = normalized(border.rim.places[(i + count - 1) % count] - border.rim.places[(i + 1) % count]);
      const Vector normal = normal_at(side, before);
      const Vector tangent = normalized(cross(along, normal));
      border.normals.push_back(normal);
      border.rim.tangents.push_back(tangent == Vector{} ? normal : tangent);
    }
    return border;
  }

 private:
  Vector place(std::uint32_t vertex) const { return welded_.positions[vertex]; }

  Vector face_normal(std::uint32_t side) const {
    const auto& [a, b, c] = welded_.triangles[side / 3];
    return normalized(cross(place(b) - place(a), place(c) - place(a)));
  }

  /// Of the surface where a side begins; `before` ends there. The mesh's own where its faces agree with it.
  Vector normal_at(std::uint32_t side, std::uint32_t before) const {
    const Vector faces = normalized(face_normal(side) + face_normal(before));
    if (!mesh_.normals.empty()) {
      const Vector own = mesh_.normals[vertex_at_[start_of(welded_.triangles, side)]];
      if (dot(own, faces) > 0.5) return own;
    }
    return faces == Vector{} ? Vector{0, 0, 1} : faces;
  }

  const Mesh& mesh_;
  const WeldedMesh& welded_;
  std::vector<std::size_t> vertex_at_;  ///< of the mesh, by distinct position
};

/// Whether all of a rim is seen from its middle, looking along the normal.
bool is_seen_whole(const Rim& rim, const DomeShape& shape) {
  const std::size_t count = rim.places.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vector p = rim.places[i] - shape.middle, q = rim.places[(i + 1) % count] - shape.middle;
    if (!(dot(cross(p, q), shape.normal) > 0)) return false;
  }
  return true;
}

CapMesh flat_cap(const Border& border) {
  CapMesh cap;
  cap.places = border.rim.places;
  const auto count = static_cast<std::uint32_t>(cap.places.size());
  const DomeShape shape = dome_shape(border.rim);
  // A fan of three from a middle has no diagonal, so it never doubles an edge of the surface.
  if (count == 3 || !is_seen_whole(border.rim, shape)) {
    PolygonCutter cutter(most_ears);
    cutter.cut(border.rim.places, cap.triangles);
    return cap;
  }
  const std::uint32_t middle = cap.add(shape.middle);
  for (std::uint32_t i = 0; i < count; ++i) cap.triangles.push_back({i, (i + 1) % count, middle});
  return cap;
}

CapMesh dome_cap(const Border& border, std::size_t rings) {
  CapMesh cap;
  cap.places = border.rim.places;
  cap.rim_normals = border.normals;
  const auto count = static_cast<std::uint32_t>(cap.places.size());
  const DomeShape shape = dome_shape(border.rim);
  for (std::size_t ring = 1; ring < rings; ++ring) {
    const auto below = static_cast<std::uint32_t>((ring - 1) * count), above = below + count;
    const double share = static_cast<double>(ring) / static_cast<double>(rings);
    const std::vector<Vector> places = dome_ring(border.rim, shape.apex, share);
    cap.places.insert(cap.places.end(), places.begin(), places.end());
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t next = (i + 1) % count;
      cap.triangles.push_back({below + i, below + next, above + next});
      cap.triangles.push_back({below + i, above + next, above + i});
    }
  }
  const auto last = static_cast<std::uint32_t>((rings - 1) * count);
  const std::uint32_t apex = cap.add(shape.apex);
  for (std::uint32_t i = 0; i < count; ++i) cap.triangles.push_back({last + i, last + (i + 1) % count, apex});
  return cap;
}

/// A cap as a mesh that goes with the one it closes.
SharedMesh finished_cap(const CapMesh& cap, const Mesh& closed, const Cancel& cancel) {
  auto mesh = std::make_shared<Mesh>();
  mesh->color = closed.color;
  mesh->finish = closed.finish;
  mesh->positions = Column<Point>(cap.places.size());
  for (std::size_t i = 0; i < cap.places.size(); ++i) mesh->positions.set(i, to_point(cap.places[i]));
  mesh->triangles.edit().assign(cap.triangles.begin(), cap.triangles.end());
  Column<Vector> normals = smooth_normals(*mesh, cancel);
  for (std::size_t i = 0; i < cap.rim_normals.size(); ++i) normals.set(i, cap.rim_normals[i]);
  mesh->normals = std::move(normals);
  return mesh;
}

}  // namespace

CappedMesh capped(const Mesh& mesh, const CapOptions& options, const Cancel& cancel) {
  CappedMesh result;
  const WeldedMesh surface = welded(mesh, cancel);
  const MeshSides sides = sides_of(surface.triangles, surface.positions.size(), cancel);
  const BorderLoops borders = border_loops(surface, sides, cancel);
  result.fault = fault_of(surface, sides, borders);
  result.caps = borders.loops.size();
  const std::size_t rings = options.kind == CapKind::dome ? options.rings : 1;
  result.too_large = sides.borders.size() * rings + result.caps > options.most_vertices;
  if (result.fault || result.too_large || cancel.stopped()) return result;
  if (borders.loops.empty()) {
    result.mesh = mesh;
    return result;
  }
  std::vector<SharedMesh> parts = {std::make_shared<const Mesh>(mesh)};
  const Caps caps(mesh, surface, cancel);
  for (const std::vector<std::uint32_t>& loop : borders.loops) {
    if (cancel.stopped()) return {};
    const Border border = caps.border(loop);
    parts.push_back(
        finished_cap(options.kind == CapKind::dome ? dome_cap(border, rings) : flat_cap(border), mesh, cancel));
  }
  result.mesh = merge(parts, cancel);
  return result;
}

}  // namespace dini

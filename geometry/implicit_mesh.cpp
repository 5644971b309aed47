#include "geometry/implicit_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "geometry/chunks.h"
#include "geometry/field_blend.h"
#include "geometry/field_shapes.h"
#include "geometry/implicit_brick.h"

namespace dini {

namespace {

using Cell = std::array<std::uint32_t, 3>;
using Triangle = std::array<std::uint32_t, 3>;

constexpr std::size_t most_in_tile = 20'000;
constexpr std::size_t most_kept_field = 2048;  ///< bytes

/// A cell around an edge of the grid, and the edge's number in it.
struct CellAtEdge {
  Cell cell;
  const CrossedCell* crossed;
  std::uint32_t first;  ///< of the vertices of its brick
  int edge;

  std::uint32_t vertex() const { return first + crossed->first + crossed->vertices[static_cast<std::size_t>(edge)]; }
};

/// A curve that the surface draws on a face between two cells: the upper cell, the axis across, which of two.
using FaceCurve = std::array<std::uint32_t, 5>;

class Mesher {
 public:
  Mesher(const SharedField& field, const ImplicitOptions& options, const Cancel& cancel)
      : options_(options),
        cancel_(cancel),
        grid_(implicit_grid(options.low, options.high, options.resolution)),
        box_(box_field(options.low, options.high)),
        field_(intersection_field({field, box_}, 0)) {}

  ImplicitSurface run() {
    find_surfaces();
    if (cancel_.stopped()) return {};
    if (found_vertices_ > options_.most_vertices) return {{}, true, false};
    std::size_t vertices = 0;
    for (const BrickSurface& surface : surfaces_) {
      firsts_.push_back(static_cast<std::uint32_t>(vertices));
      vertices += surface.places.size();
    }
    split_double_edges(vertices);
    if (cancel_.stopped()) return {};
    if (vertices > options_.most_vertices) return {{}, true, false};
    return assemble(vertices);
  }

 private:
  void find_surfaces() {
    std::vector<std::pair<Brick, BrickSurface>> found;
    std::mutex finding;
    std::size_t kept_bytes = 0;
    visit_bricks(field_, grid_, options_.most_field_bytes, cancel_, [&](const Brick& brick) {
      BrickSurface surface = surface_in(brick, grid_, cancel_);
      if (surface.crossed.empty()) return true;
      const std::size_t bytes = brick.field->size().bytes;
      const std::lock_guard lock(finding);
      found_vertices_ += surface.places.size();
      // Only a field that has become small is kept, as long as there is room; the whole one has the same values.
      const bool is_kept = bytes <= most_kept_field && kept_bytes + bytes <= options_.most_field_bytes;
      if (is_kept) kept_bytes += bytes;
      found.emplace_back(Brick{brick.cell, is_kept ? brick.field : field_}, std::move(surface));
      return found_vertices_ <= options_.most_vertices;
    });
    std::ranges::sort(found, {}, [](const auto& each) { return octree_order(each.first); });
    for (auto& [brick, surface] : found) {
      bricks_.push_back(std::move(brick));
      surfaces_.push_back(std::move(surface));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) sides_[axis] = (grid_.cells[axis] + Brick::side - 1) / Brick::side;
    brick_at_.assign(std::size_t{sides_[0]} * sides_[1] * sides_[2], none);
    for (std::uint32_t b = 0; b < bricks_.size(); ++b) brick_at_[brick_index(bricks_[b].cell)] = b;
  }

  std::size_t brick_index(const Cell& cell) const {
    return cell[0] / Brick::side +
           std::size_t{sides_[0]} * (cell[1] / Brick::side + std::size_t{sides_[1]} * (cell[2] / Brick::side));
  }

  /// The crossed cell at a place. An edge of the grid that the surface crosses has crossed cells all around, since
  /// signs at a corner agree in all bricks.
  CellAtEdge cell_at(const Cell& cell, int edge) const {
    const std::uint32_t brick = brick_at_[brick_index(cell)];
    constexpr std::uint32_t within = Brick::side - 1;
    return {cell, surfaces_[brick].cell(cell[0] & within, cell[1] & within, cell[2] & within), firsts_[brick], edge};
  }

  Cell place_of(std::size_t brick, const CrossedCell& cell) const {
    const Cell& first = bricks_[brick].cell;
    return {first[0] + cell.place[0], first[1] + cell.place[1], first[2] + cell.place[2]};
  }

  static Cell lowered(Cell cell, std::size_t axis) {
    --cell[axis];
    return cell;
  }

  /// Where one loop passes twice through a face and meets one loop on the other side, two edges of the mesh would join
  /// the same two vertices. Both get a vertex in the middle of their curve on the face.
  void split_double_edges(std::size_t& vertices) {
    for (std::size_t b = 0; b < bricks_.size() && !cancel_.stopped(); ++b) {
      for (const CrossedCell& upper : surfaces_[b].crossed) {
        if (upper.loops.doubled == 0 || cancel_.stopped()) continue;
        for (int axis = 0; axis < 3; ++axis) {
          if (!upper.loops.is_doubled(2 * axis)) continue;
          const Cell place = place_of(b, upper);
          const CellAtEdge lower = cell_at(lowered(place, static_cast<std::size_t>(axis)), 0);
          if (!lower.crossed->loops.is_doubled(2 * axis + 1)) continue;
          for (int curve = 0; curve < 2; ++curve) add_on_face(b, upper, place, axis, curve, vertices);
        }
      }
    }
  }

  void add_on_face(std::size_t brick, const CrossedCell& cell, const Cell& place, int axis, int curve,
                   std::size_t& vertices) {
    const ScalarField& field = *bricks_[brick].field;
    Vector middle;
    for (const int edge : edges_of_face(2 * axis)) {
      if (cell.loops.curve_on(2 * axis, edge) != curve) continue;
      const auto corner = [&](int c) {
        const auto bits = static_cast<std::uint32_t>(c);
        return grid_.corner(place[0] + (bits & 1), place[1] + (bits >> 1 & 1), place[2] + (bits >> 2 & 1));
      };
      const auto [from, to] = ends_of_edge(edge);
      middle = middle + 0.5 * crossing_between(field, corner(from), corner(to));
    }
    on_faces_.emplace(
        FaceCurve{place[0], place[1], place[2], static_cast<std::uint32_t>(axis), static_cast<std::uint32_t>(curve)},
        static_cast<std::uint32_t>(vertices++));
    extra_places_.push_back(middle);
    extra_normals_.push_back(normal_at(field, middle, {0, 0, 1}));
  }

  /// The vertex on the face between two cells around an edge, if there is one.
  std::optional<std::uint32_t> on_face_between(const CellAtEdge& a, const CellAtEdge& b) const {
    if (on_faces_.empty()) return std::nullopt;
    std::uint32_t axis = 0;
    while (a.cell[axis] == b.cell[axis]) ++axis;
    const CellAtEdge& upper = a.cell[axis] > b.cell[axis] ? a : b;
    const int face = 2 * static_cast<int>(axis);
    if (!upper.crossed->loops.is_doubled(face)) return std::nullopt;
    const auto curve = static_cast<std::uint32_t>(upper.crossed->loops.curve_on(face, upper.edge));
    const auto found = on_faces_.find({upper.cell[0], upper.cell[1], upper.cell[2], axis, curve});
    return found == on_faces_.end() ? std::nullopt : std::optional(found->second);
  }

  Vector place_of_vertex(const CellAtEdge& at) const {
    const std::uint32_t brick = brick_at_[brick_index(at.cell)];
    return surfaces_[brick].places[at.vertex() - at.first];
  }

  /// The faces around the crossed edges of the grid whose lower end is the lower corner of a cell of the brick.
  std::vector<Triangle> triangles_of(std::size_t brick) const {
    std::vector<Triangle> triangles;
    for (const CrossedCell& cell : surfaces_[brick].crossed) {
      if (cancel_.stopped()) break;
      const Cell place = place_of(brick, cell);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const int edge = 4 * static_cast<int>(axis);
        if (cell.vertices[static_cast<std::size_t>(edge)] == no_loop) continue;
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::array<CellAtEdge, 4> around = {cell_at(lowered(lowered(place, u), v), edge + 3),
                                            cell_at(lowered(place, v), edge + 2), cell_at(place, edge),
                                            cell_at(lowered(place, u), edge + 1)};
        if ((cell.inside & 1) == 0) std::swap(around[1], around[3]);
        add_face(brick, around, triangles);
      }
    }
    return triangles;
  }

  void add_face(std::size_t brick, const std::array<CellAtEdge, 4>& around, std::vector<Triangle>& triangles) const {
    std::vector<std::uint32_t> polygon;
    std::size_t center = 0;
    bool split = false;
    for (std::size_t k = 0; k < 4; ++k) {
      polygon.push_back(around[k].vertex());
      if (const auto middle = on_face_between(around[k], around[(k + 1) % 4])) {
        if (!split) center = polygon.size();
        split = true;
        polygon.push_back(*middle);
      }
    }
    // A fan around a vertex on a face joins no two vertices of cells anew.
    if (!split) center = first_of_diagonal(brick, around);
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      const auto at = [&](std::size_t step) { return polygon[(center + step) % polygon.size()]; };
      triangles.push_back({at(0), at(k), at(k + 1)});
    }
  }

  /// Where a quad is cut: along the shorter diagonal, and on an edge of the surface along the one nearer to it.
  std::size_t first_of_diagonal(std::size_t brick, const std::array<CellAtEdge, 4>& around) const {
    std::array<Vector, 4> places;
    for (std::size_t k = 0; k < 4; ++k) places[k] = place_of_vertex(around[k]);
    if (std::any_of(around.begin(), around.end(), [](const CellAtEdge& at) { return at.crossed->sharp; })) {
      const auto distance = [&](std::size_t from) {
        return std::abs(value_at(*bricks_[brick].field, 0.5 * places[from] + 0.5 * places[from + 2]));
      };
      return distance(1) < distance(0) ? 1 : 0;
    }
    return squared_length(places[3] - places[1]) < squared_length(places[2] - places[0]) ? 1 : 0;
  }

  ImplicitSurface assemble(std::size_t vertices) {
    std::vector<std::vector<Triangle>> triangles(bricks_.size());
    for_chunks(cancel_, bricks_.size(), 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) triangles[b] = triangles_of(b);
    });
    ImplicitSurface surface;
    Column<Point> positions(vertices);
    Column<Vector> normals(vertices);
    std::size_t next = 0;
    const auto add = [&](const std::vector<Vector>& places, const std::vector<Vector>& directions) {
      for (std::size_t i = 0; i < places.size(); ++i, ++next) {
        positions.set(next, to_point(places[i]));
        normals.set(next, directions[i]);
        surface.capped = surface.capped || value_at(*box_, places[i]) > -1e-6 * grid_.step;
      }
    };
    std::size_t count = 0;
    for (const std::vector<Triangle>& part : triangles) count += part.size();
    NumberList<Triangle> all;
    all.reserve(count);
    std::vector<std::size_t> tile_ends;
    for (std::size_t b = 0; b < bricks_.size() && !cancel_.stopped(); ++b) {
      add(surfaces_[b].places, surfaces_[b].normals);
      const std::size_t begin = tile_ends.empty() ? 0 : tile_ends.back();
      if (all.size() > begin && all.size() + triangles[b].size() - begin > most_in_tile)
        tile_ends.push_back(all.size());
      for (const Triangle& triangle : triangles[b]) all.push_back(triangle);
    }
    add(extra_places_, extra_normals_);
    if (!tile_ends.empty() && all.size() > tile_ends.back()) tile_ends.push_back(all.size());
    surface.mesh.positions = std::move(positions);
    surface.mesh.normals = std::move(normals);
    surface.mesh.triangles = std::move(all);
    surface.mesh.tile_ends = std::move(tile_ends);
    return surface;
  }

  static constexpr std::uint32_t none = ~std::uint32_t{0};

  const ImplicitOptions& options_;
  const Cancel& cancel_;
  ImplicitGrid grid_;
  SharedField box_, field_;
  std::vector<Brick> bricks_;
  std::vector<BrickSurface> surfaces_;  ///< all of them cross something
  std::size_t found_vertices_ = 0;
  std::vector<std::uint32_t> firsts_;  ///< vertex of each brick
  std::array<std::uint32_t, 3> sides_{};
  std::vector<std::uint32_t> brick_at_;
  std::map<FaceCurve, std::uint32_t> on_faces_;
  std::vector<Vector> extra_places_, extra_normals_;
};

}  // namespace

ImplicitSurface implicit_mesh(const SharedField& field, const ImplicitOptions& options, const Cancel& cancel) {
  return Mesher(field, options, cancel).run();
}

}  // namespace dini

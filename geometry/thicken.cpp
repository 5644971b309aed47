#include "geometry/thicken.h"

#include "geometry/border_strips.h"
#include "geometry/chunks.h"
#include "geometry/contacts.h"
#include "geometry/normals.h"
#include "geometry/tile_ends.h"

namespace dini {

namespace {

/// Where the distinct positions of a surface go that moves by `distance` along its normals.
std::vector<Vector> sheet_at(const WallSurface& surface, const Wall& wall, double distance, const Cancel& cancel) {
  std::vector<Vector> places(surface.welded.positions.size());
  for_chunks(cancel, places.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double share = wall.shares.empty() ? 1 : wall.shares[i];
      places[i] = surface.welded.positions[i] + (share * distance) * surface.moves.directions[i];
    }
  });
  return places;
}

/// Adds the triangles of the surface as those of one sheet, whose vertices begin at `first`.
void add_sheet(const WallSurface& surface, std::uint32_t first, bool turned, Mesh& sheets, CancelEvery& steps) {
  auto& triangles = sheets.triangles.edit();
  auto& ends = sheets.tile_ends.edit();
  const auto at = [&](std::uint32_t vertex) { return surface.welded.vertex_of[vertex]; };
  const std::size_t count = surface.mesh.triangles.size();
  std::size_t tile = 0;
  for (std::size_t i = 0; i < count && !steps.stopped(); ++i) {
    const auto& [a, b, c] = surface.mesh.triangles[i];
    if (at(a) != at(b) && at(b) != at(c) && at(c) != at(a)) {
      triangles.push_back(turned ? Corners{first + a, first + c, first + b} : Corners{first + a, first + b, first + c});
    }
    const std::size_t end = surface.mesh.tile_ends.empty() ? count : surface.mesh.tile_ends[tile];
    if (i + 1 < end) continue;
    end_tile(ends, triangles.size());
    ++tile;
  }
}

template <class Items>
void double_items(const Items& items, Items& twice) {
  twice.reserve(2 * items.size());
  twice.insert(twice.end(), items.begin(), items.end());
  twice.insert(twice.end(), items.begin(), items.end());
}

/// Both sheets: vertex i of the surface is i in front and its number of vertices more behind.
Mesh two_sheets(const WallSurface& surface, const std::vector<Vector>& front, const std::vector<Vector>& back,
                const Cancel& cancel) {
  const Mesh& mesh = surface.mesh;
  const std::size_t count = mesh.positions.size();
  Mesh sheets;
  sheets.color = mesh.color;
  sheets.finish = mesh.finish;
  Column<Point> positions(2 * count);
  for_chunks(cancel, count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t vertex = surface.welded.vertex_of[i];
      const bool used = vertex != none_of_them;
      positions.set(i, used ? to_point(front[vertex]) : mesh.positions[i]);
      positions.set(count + i, used ? to_point(back[vertex]) : mesh.positions[i]);
    }
  });
  sheets.positions = std::move(positions);
  double_items(*mesh.uvs, sheets.uvs.edit());
  double_items(*mesh.colors, sheets.colors.edit());
  sheets.triangles.reserve(2 * mesh.triangles.size() + 2 * surface.sides.borders.size());
  CancelEvery steps(cancel);
  add_sheet(surface, 0, false, sheets, steps);
  add_sheet(surface, static_cast<std::uint32_t>(count), true, sheets, steps);
  return sheets;
}

/// The normals of both sheets: those of the surface where they are right, else as their triangles say.
Column<Vector> normals_of_sheets(const WallSurface& surface, const Wall& wall, const Mesh& sheets,
                                 const Cancel& cancel) {
  const std::size_t count = surface.mesh.positions.size();
  const bool kept = !surface.mesh.normals.empty() && (wall.shares.empty() || !surface.moves.smooth);
  if (!kept) return smooth_normals(sheets, cancel);
  Column<Vector> normals(2 * count);
  for_chunks(cancel, count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      normals.set(i, surface.mesh.normals[i]);
      normals.set(count + i, -surface.mesh.normals[i]);
    }
  });
  return normals;
}

/// The wall between distinct positions: those of its front, then those of its back.
WeldedMesh bare_wall(const WallSurface& surface, std::vector<Vector> front, const std::vector<Vector>& back,
                     CancelEvery& steps) {
  WeldedMesh wall;
  const auto count = static_cast<std::uint32_t>(front.size());
  wall.positions = std::move(front);
  wall.positions.insert(wall.positions.end(), back.begin(), back.end());
  wall.triangles = surface.welded.triangles;
  wall.triangles.reserve(2 * wall.triangles.size() + 2 * surface.sides.borders.size());
  for (const auto& [a, b, c] : surface.welded.triangles) {
    if (steps.stopped()) return {};
    wall.triangles.push_back({count + a, count + c, count + b});
  }
  for (const std::uint32_t side : surface.sides.borders) {
    const std::uint32_t p = start_of(surface.welded.triangles, side), q = end_of(surface.welded.triangles, side);
    wall.triangles.push_back({q, p, count + p});
    wall.triangles.push_back({q, count + p, count + q});
  }
  return wall;
}

/// Whether a triangle went beyond the center of a bend: it shows its back, or one of its sides runs the other way.
/// Beyond the center of a ball, where both ways around bend, only the sides tell.
bool is_turned(const std::vector<Vector>& before, const std::vector<Vector>& after, const Corners& corners) {
  std::array<Vector, 3> old_sides, new_sides;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t from = corners[k], to = corners[(k + 1) % 3];
    old_sides[k] = before[to] - before[from];
    new_sides[k] = after[to] - after[from];
    if (dot(old_sides[k], new_sides[k]) < 0) return true;
  }
  return dot(cross(old_sides[0], old_sides[1]), cross(new_sides[0], new_sides[1])) < 0;
}

std::optional<Vector> place_of_contact(const WallSurface& surface, const Wall& wall, double share,
                                       const Cancel& cancel) {
  const std::vector<Vector> front = sheet_at(surface, wall, share * wall.front, cancel),
                            back = sheet_at(surface, wall, -share * wall.back, cancel);
  CancelEvery steps(cancel);
  for (const Corners& corners : surface.welded.triangles) {
    if (steps.stopped()) return std::nullopt;
    for (const std::vector<Vector>* sheet : {&front, &back}) {
      if (is_turned(surface.welded.positions, *sheet, corners)) {
        return ((*sheet)[corners[0]] + (*sheet)[corners[1]] + (*sheet)[corners[2]]) / 3;
      }
    }
  }
  return contacts_of(bare_wall(surface, front, back, steps), 1, cancel).place;
}

}  // namespace

WallSurface wall_surface(const Mesh& mesh, const Cancel& cancel) {
  WallSurface surface{mesh, welded(mesh, cancel), {}, {}, {}, {}};
  const WeldedMesh& bare = surface.welded;
  if (cancel.stopped()) return surface;
  surface.sides = sides_of(bare.triangles, bare.positions.size(), cancel);
  if (cancel.stopped()) return surface;
  surface.borders = border_loops(bare, surface.sides, cancel);
  surface.fault = fault_of(bare, surface.sides, surface.borders);
  if (surface.fault) return surface;
  surface.moves = displacements(mesh, bare, cancel);
  return surface;
}

Mesh wall_along(const WallSurface& surface, const Wall& wall, const Cancel& cancel) {
  if (surface.welded.triangles.empty() || cancel.stopped()) return {};
  const std::vector<Vector> front = sheet_at(surface, wall, wall.front, cancel),
                            back = sheet_at(surface, wall, -wall.back, cancel);
  if (cancel.stopped()) return {};
  Mesh mesh = two_sheets(surface, front, back, cancel);
  if (cancel.stopped()) return {};
  mesh.normals = normals_of_sheets(surface, wall, mesh, cancel);
  if (cancel.stopped()) return {};
  add_border_strips(surface, front, back, mesh, cancel);
  return cancel.stopped() ? Mesh{} : mesh;
}

std::optional<WallContact> contact_of(const WallSurface& surface, const Wall& wall, const Cancel& cancel) {
  const std::optional<Vector> place = place_of_contact(surface, wall, 1, cancel);
  if (!place) return std::nullopt;
  double fits = 0, too_much = 1;
  for (int step = 0; step < 10 && !cancel.stopped(); ++step) {
    const double middle = 0.5 * (fits + too_much);
    (place_of_contact(surface, wall, middle, cancel) ? too_much : fits) = middle;
  }
  return WallContact{*place, fits};
}

}  // namespace dini

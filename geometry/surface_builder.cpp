#include "geometry/surface_builder.h"

#include <limits>

#include "geometry/clip.h"

namespace dini {

namespace {

constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

/// A diagonal must be shorter by this part to be taken instead of the first one, so that round-off does not decide on
/// symmetric surfaces.
constexpr double shorter = 1 - 1e-9;

/// Whether a quad a b c d is split into b c d and d a b instead of a b c and c d a.
bool splits_second_diagonal(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  const Vector ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b;
  const bool first_flat = dot(cross(ab, ac), cross(ac, ad)) > 0;
  const bool second_flat = dot(cross(ab, ad), cross(bc, bd)) > 0;
  if (first_flat != second_flat) return second_flat;
  return squared_length(bd) < squared_length(ac) * shorter;
}

}  // namespace

SurfaceBuilder::SurfaceBuilder(const GridSamples& samples, const Cancel& cancel)
    : samples_(samples), cancel_(cancel), vertex_of_(samples.size(), no_vertex) {
  const std::size_t quads = samples.rows().steps() * samples.columns().steps();
  triangles_.reserve(2 * quads);
  vertices_.reserve(samples.size());
  positions_.reserve(samples.size());
  uvs_.reserve(samples.size());
}

void SurfaceBuilder::add_quad(std::size_t row, std::size_t column) {
  const std::size_t next_row = samples_.rows().next(row);
  const std::size_t next_column = samples_.columns().next(column);
  const std::size_t a = samples_.index(row, column), b = samples_.index(next_row, column);
  const std::size_t c = samples_.index(next_row, next_column), d = samples_.index(row, next_column);
  const auto infinite = [&](std::size_t sample) { return samples_.place(sample) == Place::infinite; };
  const auto inside = [&](std::size_t sample) { return samples_.place(sample) == Place::inside; };
  if (!inside(a) || !inside(b) || !inside(c) || !inside(d)) ++clipped_quads_;
  if (samples_.torn(a)) {
    if (inside(a) && inside(b) && inside(c) && inside(d)) ++clipped_quads_;
    return;
  }
  // A diagonal that ends at infinity would cost both triangles.
  const bool second = infinite(a) || infinite(c)   ? true
                      : infinite(b) || infinite(d) ? false
                                                   : splits_second_diagonal(samples_.position(a), samples_.position(b),
                                                                            samples_.position(c), samples_.position(d));
  if (second) {
    add_triangle({a, b, d});
    add_triangle({b, c, d});
  } else {
    add_triangle({a, b, c});
    add_triangle({a, c, d});
  }
}

void SurfaceBuilder::add_triangle(const Corners& corners) {
  std::array<std::uint32_t, 4> polygon = {};
  std::size_t count = 0;
  std::size_t inside_count = 0;
  for (const std::size_t corner : corners) {
    if (samples_.place(corner) == Place::infinite) return;
    if (samples_.place(corner) == Place::inside) ++inside_count;
  }
  if (inside_count == 0) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t from = corners[k], to = corners[(k + 1) % 3];
    const bool from_inside = samples_.place(from) == Place::inside;
    const bool to_inside = samples_.place(to) == Place::inside;
    if (from_inside) polygon[count++] = sample_vertex(from);
    if (from_inside != to_inside) polygon[count++] = from_inside ? cut_vertex(from, to) : cut_vertex(to, from);
  }
  emit(polygon[0], polygon[1], polygon[2]);
  if (count == 4) emit(polygon[0], polygon[2], polygon[3]);
}

void SurfaceBuilder::emit(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a == b || b == c || c == a) return;
  const Vector ab = positions_[b] - positions_[a];
  const Vector bc = positions_[c] - positions_[b];
  const Vector ca = positions_[a] - positions_[c];
  const double longest = std::max({squared_length(ab), squared_length(bc), squared_length(ca)});
  const double height = samples_.tolerance();
  // Twice the area is the longest side times its height.
  if (squared_length(cross(ab, ca)) <= height * height * longest) return;
  triangles_.push_back({a, b, c});
}

std::uint32_t SurfaceBuilder::sample_vertex(std::size_t sample) {
  const std::size_t label = samples_.label(sample);
  if (vertex_of_[label] == no_vertex) {
    vertex_of_[label] = add_vertex({label, label, 0}, samples_.position(label), coordinates(label));
  }
  return vertex_of_[label];
}

std::uint32_t SurfaceBuilder::cut_vertex(std::size_t inside, std::size_t outside) {
  const std::size_t start = samples_.label(inside);
  const auto [entry, added] = vertex_of_cut_.try_emplace(std::uint64_t{start} << 32 | outside, no_vertex, cancel_);
  if (!added) return entry;
  const Vector from = samples_.position(start);
  const Vector edge = samples_.position(outside) - from;
  const Vector direction = normalized(edge);
  const double cut = length_to_sphere(from, direction, samples_.clip_radius());
  if (cut <= samples_.tolerance()) return entry = sample_vertex(inside);
  const double way = std::min(1.0, cut / length(edge));
  // Across a seam the smaller coordinate continues one lap further, so that it does not run backwards.
  const std::array<double, 2> uv_from = coordinates(inside), uv_to = coordinates(outside);
  std::array<double, 2> uv{};
  for (std::size_t k = 0; k < 2; ++k) {
    const GridAxis& axis = k == 0 ? samples_.rows() : samples_.columns();
    const double last = axis.coordinate(axis.size() - 1);
    double a = uv_from[k], b = uv_to[k];
    if (axis.closed && a == 0 && b == last) a = 1;
    if (axis.closed && b == 0 && a == last) b = 1;
    uv[k] = a + way * (b - a);
  }
  return entry = add_vertex({start, outside, way}, from + cut * direction, uv);
}

std::uint32_t SurfaceBuilder::add_vertex(const SurfaceVertex& vertex, const Vector& position,
                                         const std::array<double, 2>& uv) {
  vertices_.push_back(vertex);
  positions_.push_back(position);
  uvs_.push_back(uv);
  return static_cast<std::uint32_t>(vertices_.size() - 1);
}

std::array<double, 2> SurfaceBuilder::coordinates(std::size_t sample) const {
  return {samples_.rows().coordinate(samples_.row_of(sample)),
          samples_.columns().coordinate(samples_.column_of(sample))};
}

void SurfaceBuilder::end_tile() {
  const std::size_t begin = tile_ends_.empty() ? 0 : tile_ends_.back();
  if (triangles_.size() > begin) tile_ends_.push_back(triangles_.size());
}

Mesh SurfaceBuilder::take_mesh() {
  end_tile();
  // Triangles without area may have brought vertices that no other one uses.
  std::vector<std::uint32_t> renamed(vertices_.size(), no_vertex);
  CancelEvery steps(cancel_);
  for (const auto& triangle : triangles_) {
    if (steps.stopped()) return {};
    for (const std::uint32_t corner : triangle) renamed[corner] = 0;
  }
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < renamed.size() && !steps.stopped(); ++i) {
    if (renamed[i] == no_vertex) continue;
    vertices_[kept] = vertices_[i];
    positions_[kept] = positions_[i];
    uvs_[kept] = uvs_[i];
    renamed[i] = kept++;
  }
  vertices_.resize(kept);
  uvs_.resize(kept);
  Mesh mesh;
  mesh.positions = Column<Point>(kept);
  for (std::size_t i = 0; i < kept && !steps.stopped(); ++i) mesh.positions.set(i, to_point(positions_[i]));
  for (auto& triangle : triangles_) {
    if (steps.stopped()) break;
    for (std::uint32_t& corner : triangle) corner = renamed[corner];
  }
  mesh.uvs = std::move(uvs_);
  mesh.triangles = std::move(triangles_);
  mesh.tile_ends = std::move(tile_ends_);
  return mesh;
}

}  // namespace dini

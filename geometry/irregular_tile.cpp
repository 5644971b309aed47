#include "geometry/irregular_tile.h"

#include <algorithm>

#include "geometry/clip.h"
#include "geometry/number_table.h"

namespace dini {

namespace {

/// Whether a quad a b c d must be split into b c d and d a b: when a b c and c d a are folded and those are not.
bool needs_second_diagonal(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  const Vector ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b;
  const bool first_flat = dot(cross(ab, ac), cross(ac, ad)) > 0;
  return !first_flat && dot(cross(ab, ad), cross(bc, bd)) > 0;
}

class TileBuilder {
 public:
  TileBuilder(const GridSamples& samples, const Cancel& cancel) : samples_(samples), cancel_(cancel) {}

  void add(const TilePiece& piece);
  IrregularTile take() { return std::move(tile_); }

 private:
  using Corners = std::array<std::size_t, 3>;

  void add_plain_quad(std::size_t row, std::size_t column);
  void add_quad(std::size_t row, std::size_t column);
  void add_triangle(const Corners& corners);
  void emit(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  std::uint32_t sample_vertex(std::size_t sample) const { return static_cast<std::uint32_t>(samples_.label(sample)); }
  std::uint32_t cut_vertex(std::size_t inside, std::size_t outside);

  const GridSamples& samples_;
  const Cancel& cancel_;
  NumberTable vertex_of_cut_;  ///< by samples inside and outside
  IrregularTile tile_;
};

void TileBuilder::add(const TilePiece& piece) {
  const std::size_t begin = tile_.triangles.size();
  for (std::size_t row = piece.block.row_begin; row < piece.block.row_end && !cancel_.stopped(); ++row) {
    for (std::size_t column = piece.block.column_begin; column < piece.block.column_end; ++column) {
      if (piece.plain) {
        add_plain_quad(row, column);
      } else {
        add_quad(row, column);
      }
    }
  }
  if (!piece.plain) tile_.runs.push_back({begin, tile_.triangles.size()});
}

void TileBuilder::add_plain_quad(std::size_t row, std::size_t column) {
  const std::size_t next_row = samples_.rows().next(row), next_column = samples_.columns().next(column);
  const std::size_t a = samples_.index(row, column), b = samples_.index(next_row, column);
  const std::size_t c = samples_.index(next_row, next_column), d = samples_.index(row, next_column);
  if (samples_.label(a) != a || samples_.label(b) != b || samples_.label(c) != c || samples_.label(d) != d) {
    return add_quad(row, column);
  }
  const auto corner = [](std::size_t sample) { return static_cast<std::uint32_t>(sample); };
  tile_.triangles.push_back({corner(a), corner(b), corner(c)});
  tile_.triangles.push_back({corner(a), corner(c), corner(d)});
}

void TileBuilder::add_quad(std::size_t row, std::size_t column) {
  const std::size_t next_row = samples_.rows().next(row);
  const std::size_t next_column = samples_.columns().next(column);
  const std::size_t a = samples_.index(row, column), b = samples_.index(next_row, column);
  const std::size_t c = samples_.index(next_row, next_column), d = samples_.index(row, next_column);
  const auto infinite = [&](std::size_t sample) { return samples_.place(sample) == Place::infinite; };
  const auto inside = [&](std::size_t sample) { return samples_.place(sample) == Place::inside; };
  if (samples_.torn(a) || !inside(a) || !inside(b) || !inside(c) || !inside(d)) ++tile_.clipped_quads;
  if (samples_.torn(a)) return;
  // A diagonal that ends at infinity would cost both triangles.
  const bool second = infinite(a) || infinite(c)   ? true
                      : infinite(b) || infinite(d) ? false
                                                   : needs_second_diagonal(samples_.position(a), samples_.position(b),
                                                                           samples_.position(c), samples_.position(d));
  if (second) {
    add_triangle({a, b, d});
    add_triangle({b, c, d});
  } else {
    add_triangle({a, b, c});
    add_triangle({a, c, d});
  }
}

void TileBuilder::add_triangle(const Corners& corners) {
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

void TileBuilder::emit(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a == b || b == c || c == a) return;
  const Vector at_a = corner_position(samples_, tile_, a), at_b = corner_position(samples_, tile_, b);
  const Vector at_c = corner_position(samples_, tile_, c);
  const Vector ab = at_b - at_a, bc = at_c - at_b, ca = at_a - at_c;
  const double longest = std::max({squared_length(ab), squared_length(bc), squared_length(ca)});
  const double height = samples_.tolerance();
  // Twice the area is the longest side times its height.
  if (squared_length(cross(ab, ca)) <= height * height * longest) return;
  tile_.triangles.push_back({a, b, c});
}

std::uint32_t TileBuilder::cut_vertex(std::size_t inside, std::size_t outside) {
  const std::size_t start = samples_.label(inside);
  const auto fresh = static_cast<std::uint32_t>(samples_.size() + tile_.cuts.size());
  const auto [entry, added] = vertex_of_cut_.try_emplace(std::uint64_t{start} << 32 | outside, fresh, cancel_);
  if (!added) return entry;
  const Vector from = samples_.position(start);
  const Vector edge = samples_.position(outside) - from;
  const Vector direction = normalized(edge);
  const double cut = length_to_sphere(from, direction, samples_.clip_radius());
  if (cut <= samples_.tolerance()) return entry = sample_vertex(inside);
  const double way = std::min(1.0, cut / length(edge));
  // Across a seam the smaller coordinate continues one lap further, so that it does not run backwards.
  const std::array<double, 2> uv_from = coordinates_of(samples_, inside), uv_to = coordinates_of(samples_, outside);
  std::array<double, 2> uv{};
  for (std::size_t k = 0; k < 2; ++k) {
    const GridAxis& axis = k == 0 ? samples_.rows() : samples_.columns();
    const double last = axis.coordinate(axis.size() - 1);
    double a = uv_from[k], b = uv_to[k];
    if (axis.closed && a == 0 && b == last) a = 1;
    if (axis.closed && b == 0 && a == last) b = 1;
    uv[k] = a + way * (b - a);
  }
  tile_.cuts.push_back({start, outside, way, from + cut * direction, uv});
  return entry;
}

}  // namespace

IrregularTile irregular_tile(const GridSamples& samples, const std::vector<TilePiece>& pieces, const Cancel& cancel) {
  TileBuilder builder(samples, cancel);
  for (const TilePiece& piece : pieces) builder.add(piece);
  return builder.take();
}

std::array<double, 2> coordinates_of(const GridSamples& samples, std::size_t sample) {
  return {samples.rows().coordinate(samples.row_of(sample)), samples.columns().coordinate(samples.column_of(sample))};
}

}  // namespace dini

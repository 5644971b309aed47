#include "geometry/implicit_brick.h"

#include <algorithm>

#include "geometry/implicit_vertex.h"

namespace dini {

namespace {

/// The values at many places; between some the flag is looked at. Stopped early: some are not written.
void measure(const ScalarField& field, const Places& at, double* out, const Cancel& cancel) {
  constexpr std::size_t operations_between = std::size_t{1} << 17, bytes_of_operation = 32;
  const std::size_t operations = field.size().operations + field.size().bytes / bytes_of_operation;
  const std::size_t chunk =
      std::clamp<std::size_t>(operations_between / operations, 1, std::max<std::size_t>(1, at.count));
  for (std::size_t begin = 0; begin < at.count && !cancel.stopped(); begin += chunk) {
    const std::size_t count = std::min(chunk, at.count - begin);
    field.values({at.x + begin, at.y + begin, at.z + begin, count}, out + begin);
  }
}

/// The bracket of a zero along edges, all at once, made smaller by secants; the end that stays counts half from then on
/// (the Illinois rule).
class Secants {
 public:
  Secants(std::vector<Vector> from, std::vector<Vector> to, std::vector<double> low, std::vector<double> high)
      : from_(std::move(from)), to_(std::move(to)), low_(std::move(low)), high_(std::move(high)) {}

  /// Stopped early: places that mean nothing.
  std::vector<Vector> zeros(const ScalarField& field, const Cancel& cancel) {
    constexpr int steps = 5;
    const std::size_t count = from_.size();
    std::vector<double> begin(count, 0.0), end(count, 1.0), x(count), y(count), z(count), value(count);
    std::vector<int> moved(count, 0);
    for (int step = 0; step < steps && count > 0 && !cancel.stopped(); ++step) {
      for (std::size_t i = 0; i < count; ++i) {
        const Vector place = at(i, between(i, begin[i], end[i]));
        x[i] = place.x, y[i] = place.y, z[i] = place.z;
      }
      measure(field, {x.data(), y.data(), z.data(), count}, value.data(), cancel);
      for (std::size_t i = 0; i < count; ++i) {
        const double middle = between(i, begin[i], end[i]);
        if ((value[i] < 0) == (low_[i] < 0)) {
          begin[i] = middle;
          low_[i] = value[i];
          if (moved[i] == 1) high_[i] *= 0.5;
          moved[i] = 1;
        } else {
          end[i] = middle;
          high_[i] = value[i];
          if (moved[i] == 2) low_[i] *= 0.5;
          moved[i] = 2;
        }
      }
    }
    std::vector<Vector> places(count);
    for (std::size_t i = 0; i < count; ++i) places[i] = at(i, between(i, begin[i], end[i]));
    return places;
  }

 private:
  double between(std::size_t i, double begin, double end) const {
    const double rise = high_[i] - low_[i];
    const double share = rise != 0 && std::isfinite(rise) ? -low_[i] / rise : 0.5;
    return begin + share * (end - begin);
  }
  Vector at(std::size_t i, double share) const { return from_[i] + share * (to_[i] - from_[i]); }

  std::vector<Vector> from_, to_;
  std::vector<double> low_, high_;
};

constexpr std::uint32_t corners_on_edge = Brick::side + 1;
constexpr std::size_t corner_count = std::size_t{corners_on_edge} * corners_on_edge * corners_on_edge;

std::size_t corner_index(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  return i + corners_on_edge * (j + corners_on_edge * k);
}

class BrickSampler {
 public:
  BrickSampler(const Brick& brick, const ImplicitGrid& grid, const Cancel& cancel)
      : brick_(brick), grid_(grid), cancel_(cancel) {}

  BrickSurface run() {
    sample();
    if (cancel_.stopped()) return {};
    const bool inside = values_[0] < 0;
    if (std::all_of(values_.begin(), values_.end(), [&](double value) { return (value < 0) == inside; })) return {};
    find_crossings();
    surface_.cell_at.assign(BrickSurface::cells, BrickSurface::none);
    for (std::uint8_t k = 0; k < Brick::side; ++k) {
      for (std::uint8_t j = 0; j < Brick::side; ++j) {
        for (std::uint8_t i = 0; i < Brick::side; ++i) {
          if (cancel_.stopped()) return {};
          add_cell({i, j, k});
        }
      }
    }
    return std::move(surface_);
  }

 private:
  Vector corner(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return grid_.corner(brick_.cell[0] + i, brick_.cell[1] + j, brick_.cell[2] + k);
  }

  void sample() {
    std::vector<double> x(corner_count), y(corner_count), z(corner_count);
    for (std::uint32_t k = 0; k < corners_on_edge; ++k) {
      for (std::uint32_t j = 0; j < corners_on_edge; ++j) {
        for (std::uint32_t i = 0; i < corners_on_edge; ++i) {
          const Vector place = corner(i, j, k);
          const std::size_t index = corner_index(i, j, k);
          x[index] = place.x, y[index] = place.y, z[index] = place.z;
        }
      }
    }
    values_.resize(corner_count);
    measure(*brick_.field, {x.data(), y.data(), z.data(), corner_count}, values_.data(), cancel_);
  }

  void find_crossings() {
    std::vector<Vector> from, to;
    std::vector<double> low, high;
    std::vector<std::uint8_t> axes;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      crossing_at_[axis].assign(corner_count, -1);
      const std::array<std::uint32_t, 3> along = {axis == 0, axis == 1, axis == 2};
      for (std::uint32_t k = 0; k + along[2] < corners_on_edge; ++k) {
        for (std::uint32_t j = 0; j + along[1] < corners_on_edge; ++j) {
          for (std::uint32_t i = 0; i + along[0] < corners_on_edge; ++i) {
            const std::size_t lower = corner_index(i, j, k);
            const std::size_t upper = corner_index(i + along[0], j + along[1], k + along[2]);
            if ((values_[lower] < 0) == (values_[upper] < 0)) continue;
            crossing_at_[axis][lower] = static_cast<std::int16_t>(from.size());
            from.push_back(corner(i, j, k));
            to.push_back(corner(i + along[0], j + along[1], k + along[2]));
            low.push_back(values_[lower]);
            high.push_back(values_[upper]);
            axes.push_back(static_cast<std::uint8_t>(axis));
          }
        }
      }
    }
    std::vector<Vector> outward(from.size());
    for (std::size_t i = 0; i < from.size(); ++i)
      outward[i] = normalized(low[i] < 0 ? to[i] - from[i] : from[i] - to[i]);
    const std::vector<Vector> places =
        Secants(std::move(from), std::move(to), std::move(low), std::move(high)).zeros(*brick_.field, cancel_);
    crossings_.reserve(places.size());
    for (std::size_t i = 0; i < places.size() && !cancel_.stopped(); ++i) {
      crossings_.push_back({places[i], normal_at(*brick_.field, places[i], outward[i])});
    }
  }

  void add_cell(const std::array<std::uint8_t, 3>& place) {
    std::array<double, 8> values;
    unsigned inside = 0;
    for (unsigned c = 0; c < 8; ++c) {
      values[c] = values_[corner_index(place[0] + (c & 1), place[1] + (c >> 1 & 1), place[2] + (c >> 2 & 1))];
      inside |= (values[c] < 0 ? 1U : 0U) << c;
    }
    if (inside == 0 || inside == 0xFF) return;
    CrossedCell cell{place,
                     static_cast<std::uint8_t>(inside),
                     false,
                     loops_of(values),
                     static_cast<std::uint32_t>(surface_.places.size()),
                     {}};
    cell.vertices.fill(no_loop);
    const double half = 0.5 * grid_.step;
    const Vector center = corner(place[0], place[1], place[2]) + Vector{half, half, half};
    for (std::uint8_t loop = 0; loop < cell.loops.count; ++loop) add_vertex(cell, loop, center);
    surface_.cell_at[place[0] + Brick::side * (place[1] + Brick::side * place[2])] =
        static_cast<std::uint16_t>(surface_.crossed.size());
    surface_.crossed.push_back(cell);
  }

  void add_vertex(CrossedCell& cell, std::uint8_t loop, const Vector& center) {
    std::vector<Crossing> around;
    std::vector<std::size_t> edges;
    for (std::size_t edge = 0; edge < 12; ++edge) {
      if (cell.loops.loop[edge] != loop) continue;
      const auto lower = static_cast<unsigned>(ends_of_edge(static_cast<int>(edge))[0]);
      const std::size_t index =
          corner_index(cell.place[0] + (lower & 1), cell.place[1] + (lower >> 1 & 1), cell.place[2] + (lower >> 2 & 1));
      edges.push_back(edge);
      around.push_back(crossings_[static_cast<std::size_t>(crossing_at_[edge / 4][index])]);
    }
    const ImplicitVertex vertex = implicit_vertex(*brick_.field, around, center, grid_.step, cell.loops.count == 1);
    const auto first = static_cast<std::uint8_t>(surface_.places.size() - cell.first);
    for (const Vector& normal : vertex.normals) {
      surface_.places.push_back(vertex.place);
      surface_.normals.push_back(normal);
    }
    cell.sharp = cell.sharp || vertex.normals.size() > 1;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      cell.vertices[edges[k]] = static_cast<std::uint8_t>(first + vertex.normal_of[k]);
    }
  }

  const Brick& brick_;
  const ImplicitGrid& grid_;
  const Cancel& cancel_;
  std::vector<double> values_;
  std::array<std::vector<std::int16_t>, 3> crossing_at_;  ///< by axis and lower corner
  std::vector<Crossing> crossings_;
  BrickSurface surface_;
};

}  // namespace

BrickSurface surface_in(const Brick& brick, const ImplicitGrid& grid, const Cancel& cancel) {
  return BrickSampler(brick, grid, cancel).run();
}

Vector crossing_between(const ScalarField& field, const Vector& from, const Vector& to) {
  return Secants({from}, {to}, {value_at(field, from)}, {value_at(field, to)}).zeros(field, Cancel()).front();
}

Vector normal_at(const ScalarField& field, const Vector& place, const Vector& otherwise) {
  const Vector steepest = normalized(field.slope(place).gradient);
  return is_finite(steepest) && steepest != Vector{} ? steepest : otherwise;
}

}  // namespace dini

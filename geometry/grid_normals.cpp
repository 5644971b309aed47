#include "geometry/grid_normals.h"

#include <algorithm>

#include "geometry/chunks.h"
#include "geometry/corner.h"
#include "geometry/grid_lanes.h"

namespace dini {

namespace {

constexpr std::size_t reach = 4;

/// The stencil at a sample with `before` and `after` samples in reach: at most five, as centered as can be. Weights are
/// those of the interpolating polynomial, exact for uneven steps of a thinned axis.
Stencil make_stencil(const GridAxis& axis, std::size_t at, std::size_t before, std::size_t after) {
  std::size_t left = std::min<std::size_t>(before, 2);
  std::size_t right = std::min<std::size_t>(after, 2);
  while (left + right < reach && (left < before || right < after)) ++(left < before ? left : right);
  Stencil stencil{left, left + right + 1, {}};
  std::array<double, 5> offsets = {};
  std::size_t index = at;
  for (std::size_t k = 1; k <= left; ++k) {
    index = axis.previous(index);
    offsets[left - k] = offsets[left - k + 1] - axis.step_length(index);
  }
  index = at;
  for (std::size_t k = 1; k <= right; ++k) {
    offsets[left + k] = offsets[left + k - 1] + axis.step_length(index);
    index = axis.next(index);
  }
  for (std::size_t j = 0; j < stencil.count; ++j) {
    if (j == left) continue;
    double numerator = 1, denominator = offsets[j];
    for (std::size_t k = 0; k < stencil.count; ++k) {
      if (k == j || k == left) continue;
      numerator *= -offsets[k];
      denominator *= offsets[j] - offsets[k];
    }
    stencil.weights[j] = numerator / denominator;
    stencil.weights[left] -= stencil.weights[j];
  }
  return stencil;
}

/// How far stencils may reach along an axis by its borders alone; on a closed axis never around to the sample itself.
std::size_t room_before(const GridAxis& axis, std::size_t at) {
  return std::min(reach, axis.closed ? axis.size() - 1 : at);
}
std::size_t room_after(const GridAxis& axis, std::size_t at) {
  return std::min(reach, axis.closed ? axis.size() - 1 : axis.size() - 1 - at);
}

Zeroed<Stencil> stencils_of(const GridAxis& axis, const Cancel& cancel) {
  Zeroed<Stencil> stencils(axis.size());
  CancelEvery steps(cancel);
  for (std::size_t at = 0; at < axis.size() && !steps.stopped(); ++at) {
    stencils[at] = make_stencil(axis, at, room_before(axis, at), room_after(axis, at));
  }
  return stencils;
}

/// Walks along one grid line and tells which steps a stencil must not take.
class GridLine {
 public:
  GridLine(const GridSamples& samples, std::size_t sample, bool along_rows)
      : samples_(samples), row_(samples.row_of(sample)), column_(samples.column_of(sample)), along_rows_(along_rows) {}

  const GridAxis& axis() const { return along_rows_ ? samples_.rows() : samples_.columns(); }
  std::size_t at() const { return along_rows_ ? row_ : column_; }
  std::size_t sample(std::size_t at) const {
    return along_rows_ ? samples_.index(at, column_) : samples_.index(row_, at);
  }

  std::size_t free_before() const {
    std::size_t from = at(), count = 0;
    for (const std::size_t room = room_before(axis(), from); count < room; ++count) {
      const std::size_t to = axis().previous(from);
      if (samples_.place(sample(to)) != Place::inside || torn(to)) break;
      from = to;
    }
    return count;
  }

  std::size_t free_after() const {
    std::size_t from = at(), count = 0;
    for (const std::size_t room = room_after(axis(), from); count < room; ++count) {
      const std::size_t to = axis().next(from);
      if (samples_.place(sample(to)) != Place::inside || torn(from)) break;
      from = to;
    }
    return count;
  }

 private:
  /// Whether the step from `from` to the next sample is a side of a quad torn along it.
  bool torn(std::size_t from) const {
    const GridAxis& other = along_rows_ ? samples_.columns() : samples_.rows();
    const std::size_t across = along_rows_ ? column_ : row_;
    const auto torn_at = [&](std::size_t beside) {
      return along_rows_ ? samples_.torn_along_rows(samples_.index(from, beside))
                         : samples_.torn_along_columns(samples_.index(beside, from));
    };
    return torn_at(across) || torn_at(other.previous(across));
  }

  const GridSamples& samples_;
  std::size_t row_, column_;
  bool along_rows_;
};

}  // namespace

GridNormals::GridNormals(const GridSamples& samples, const Cancel& cancel)
    : samples_(samples),
      row_stencils_(stencils_of(samples.rows(), cancel)),
      column_stencils_(stencils_of(samples.columns(), cancel)) {
  const std::size_t columns = samples.columns().size();
  for (std::size_t k = 0; k < column_weights_.size(); ++k) {
    column_weights_[k] = Zeroed<double>(columns);
    for (std::size_t column = 2; column + 2 < columns; ++column) {
      column_weights_[k][column] = column_stencils_[column].weights[k < 2 ? k : k + 1];
    }
  }
}

Vector GridNormals::derivative(std::size_t sample, bool along_rows) const {
  const GridLine line(samples_, sample, along_rows);
  const GridAxis& axis = line.axis();
  const std::size_t at = line.at();
  Stencil stencil = (along_rows ? row_stencils_ : column_stencils_)[at];
  if (!samples_.whole()) {
    const std::size_t before = line.free_before();
    const std::size_t after = line.free_after();
    if (before < stencil.first || after + stencil.first + 1 < stencil.count) {
      stencil = make_stencil(axis, at, before, after);
    }
  }
  std::size_t index = at;
  for (std::size_t k = 0; k < stencil.first; ++k) index = axis.previous(index);
  const Vector center = samples_.position(sample);
  Vector sum;
  double largest = 0;
  for (std::size_t k = 0; k < stencil.count; ++k) {
    const Vector term = stencil.weights[k] * (samples_.position(line.sample(index)) - center);
    sum = sum + term;
    largest = std::max(largest, squared_length(term));
    index = axis.next(index);
  }
  return squared_length(sum) > vanishing_tangent * vanishing_tangent * largest ? sum : Vector{};
}

std::optional<Vector> GridNormals::at(std::size_t sample) const {
  if (samples_.merged(sample)) return {};
  const Vector along_row = quick_unit(derivative(sample, true));
  const Vector along_column = quick_unit(derivative(sample, false));
  const Vector normal = cross(along_row, along_column);
  if (squared_length(normal) <= parallel_tangents * parallel_tangents) return {};
  return quick_unit(normal);
}

void GridNormals::row_of_normals(std::size_t row, kernels::Points normals, std::uint8_t* doubtful) const {
  const std::size_t columns = samples_.columns().size();
  const std::size_t begin = std::min<std::size_t>(2, columns), end = columns < 5 ? begin : columns - 2;
  const auto one_by_one = [&](std::size_t from, std::size_t to) {
    for (std::size_t sample = samples_.index(row, from); sample < samples_.index(row, to); ++sample) {
      const bool known = samples_.place(sample) == Place::inside;
      const std::optional<Vector> normal = known ? at(sample) : std::nullopt;
      if (!normal) doubtful[sample] = 1;
      normals.x[sample] = normal ? normal->x : 0;
      normals.y[sample] = normal ? normal->y : 0;
      normals.z[sample] = normal ? normal->z : 0;
    }
  };
  one_by_one(0, begin);
  one_by_one(end, columns);
  const GridAxis& axis = samples_.rows();
  const Stencil& stencil = row_stencils_[row];
  grid_lanes::RowDifferences along_rows;
  std::size_t at_row = row;
  for (std::size_t k = 0; k < stencil.first; ++k) at_row = axis.previous(at_row);
  for (std::size_t k = 0; k < stencil.count; ++k, at_row = axis.next(at_row)) {
    if (at_row == row) continue;
    along_rows.rows[along_rows.count] = samples_.index(at_row, 0);
    along_rows.weights[along_rows.count++] = stencil.weights[k];
  }
  grid_lanes::ColumnDifferences along_columns = {};
  for (std::size_t k = 0; k < along_columns.size(); ++k) along_columns[k] = column_weights_[k].data();
  grid_lanes::difference_normals(samples_.positions(), samples_.index(row, 0), along_rows, along_columns, begin, end,
                                 normals, doubtful);
}

Column<Vector> GridNormals::all(Zeroed<std::uint8_t>& doubtful, const Cancel& cancel) const {
  Column<Vector> normals = Column<Vector>::unwritten(samples_.size());
  const kernels::Points out = {normals.component(0), normals.component(1), normals.component(2)};
  const std::size_t rows_at_once = std::max<std::size_t>(1, usual_chunk / samples_.columns().size());
  for_chunks(cancel, samples_.rows().size(), rows_at_once, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) row_of_normals(row, out, doubtful.data());
  });
  return normals;
}

void GridNormals::doubt_obstructed(Zeroed<std::uint8_t>& doubtful, const Cancel& cancel) const {
  const std::size_t rows = samples_.rows().size(), columns = samples_.columns().size();
  for_chunks(cancel, samples_.merged() ? samples_.size() : 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t sample = begin; sample < end; ++sample) {
      if (samples_.merged(sample)) doubtful[sample] = 1;
    }
  });
  if (samples_.whole()) return;
  Zeroed<std::uint8_t> obstacles(samples_.size());
  CancelEvery steps(cancel);
  for (std::size_t sample = 0; sample < samples_.size() && !steps.stopped(); ++sample) {
    if (samples_.place(sample) != Place::inside) obstacles[sample] = 1;
    if (!samples_.torn(sample)) continue;
    const std::size_t row = samples_.row_of(sample), column = samples_.column_of(sample);
    const std::size_t next_row = samples_.rows().next(row), next_column = samples_.columns().next(column);
    for (const std::size_t r : {row, next_row}) {
      for (const std::size_t c : {column, next_column}) obstacles[samples_.index(r, c)] = 1;
    }
  }
  // No stencil reaches further than this along either axis. Around an open axis some are doubted without need.
  const std::size_t rows_at_once = std::max<std::size_t>(1, usual_chunk / columns);
  for_chunks(cancel, rows, rows_at_once, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      std::uint8_t* const line = doubtful.data() + samples_.index(row, 0);
      for (std::size_t k = 0; k <= 2 * reach; ++k) {
        const std::uint8_t* other = obstacles.data() + samples_.index((row + reach * rows - reach + k) % rows, 0);
        for (std::size_t column = 0; column < columns; ++column) line[column] |= other[column];
      }
      const std::uint8_t* const own = obstacles.data() + samples_.index(row, 0);
      for (std::size_t column = 0; column < columns; ++column) {
        if (own[column] == 0) continue;
        for (std::size_t k = 0; k <= 2 * reach; ++k) line[(column + reach * columns - reach + k) % columns] = 1;
      }
    }
  });
}

}  // namespace dini

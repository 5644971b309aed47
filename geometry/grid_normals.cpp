#include "geometry/grid_normals.h"

#include "geometry/corner.h"

namespace dini {

namespace {

constexpr std::size_t reach = 4;

/// A tangent this small against the steps around it is what cancellation left of a turning point.
constexpr double vanishing = 1e-3;

/// Tangents whose angle has a smaller sine are parallel.
constexpr double parallel = 1e-6;

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
      column_stencils_(stencils_of(samples.columns(), cancel)) {}

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
  return squared_length(sum) > vanishing * vanishing * largest ? sum : Vector{};
}

std::optional<Vector> GridNormals::at(std::size_t sample) const {
  if (samples_.merged(sample)) return {};
  const Vector along_row = quick_unit(derivative(sample, true));
  const Vector along_column = quick_unit(derivative(sample, false));
  const Vector normal = cross(along_row, along_column);
  if (squared_length(normal) <= parallel * parallel) return {};
  return quick_unit(normal);
}

}  // namespace dini

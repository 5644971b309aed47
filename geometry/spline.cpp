#include "geometry/spline.h"

#include <algorithm>
#include <cmath>

#include "geometry/chunks.h"
#include "geometry/same_place.h"
#include "geometry/sampling.h"

namespace dini {

namespace {

/// A cubic curve in pieces: values and slopes at the knots.
class Spline {
 public:
  Spline(std::vector<Vector> points, bool closed, SplineKind kind, const Cancel& cancel)
      : points_(std::move(points)), closed_(closed), slopes_(points_.size()), looks_(cancel) {
    const std::size_t count = points_.size();
    for (std::size_t i = 0; i < pieces(); ++i) {
      const Vector step = points_[(i + 1) % count] - points_[i];
      steps_.push_back(std::sqrt(length(step)));
      rates_.push_back(step / steps_.back());
    }
    if (kind == SplineKind::smooth && count > 2) {
      find_smooth_slopes();
    } else {
      find_local_slopes();
    }
  }

  std::size_t pieces() const { return closed_ ? points_.size() : points_.size() - 1; }

  /// The point at a `share` in [0, 1] of a piece.
  Vector at(std::size_t piece, double share) const {
    const std::size_t next = (piece + 1) % points_.size();
    const double rest = 1 - share;
    const Vector bow =
        (share * rest * rest * steps_[piece]) * slopes_[piece] - (share * share * rest * steps_[piece]) * slopes_[next];
    return (rest * rest * (1 + 2 * share)) * points_[piece] + (share * share * (3 - 2 * share)) * points_[next] + bow;
  }

 private:
  /// The slope of the parabola through a knot and its neighbors; at open ends the one with which the end piece is one.
  void find_local_slopes() {
    const std::size_t count = points_.size();
    for (std::size_t i = 0; i < count && !looks_.stopped(); ++i) {
      if (!closed_ && (i == 0 || i + 1 == count)) continue;
      const std::size_t before = (i + count - 1) % count;
      slopes_[i] = (steps_[i] * rates_[before] + steps_[before] * rates_[i]) / (steps_[before] + steps_[i]);
    }
    if (closed_) return;
    const std::size_t last = count - 1;
    slopes_[0] = count > 2 ? 2 * rates_[0] - slopes_[1] : rates_[0];
    slopes_[last] = count > 2 ? 2 * rates_[last - 1] - slopes_[last - 1] : rates_[0];
  }

  /// Slopes with which second derivatives agree at the knots: a system of three diagonals, solved by elimination; for
  /// closed curves with the corners taken into a second right side (Sherman and Morrison, 1950). The system is
  /// diagonally dominant, so nothing divides by zero.
  void find_smooth_slopes() {
    const std::size_t count = points_.size();
    std::vector<double> middle(count), lower(count), upper(count);
    std::vector<Vector> right(count);
    for (std::size_t i = 0; i < count && !looks_.stopped(); ++i) {
      const bool first = !closed_ && i == 0, last = !closed_ && i + 1 == count;
      const std::size_t before = (i + count - 1) % count;
      // Weights by the other step, so that both sides of a knot count by how near its neighbor is.
      const double after = last ? 0 : 1 / steps_[i], ahead = first ? 0 : 1 / steps_[before];
      const double scale = after + ahead;
      lower[i] = ahead / scale;
      upper[i] = after / scale;
      middle[i] = 2;
      right[i] = (3 / scale) * ((first ? Vector{} : ahead * rates_[before]) + (last ? Vector{} : after * rates_[i]));
    }
    std::vector<double> corner(count);
    if (closed_) {
      // With -middle[0] in the corner the rest keeps its dominance.
      corner[0] = -middle[0];
      corner[count - 1] = upper[count - 1];
      middle[count - 1] += upper[count - 1] * lower[0] / middle[0];
      middle[0] *= 2;
    }
    for (std::size_t i = 1; i < count && !looks_.stopped(); ++i) {
      const double factor = lower[i] / middle[i - 1];
      middle[i] -= factor * upper[i - 1];
      right[i] = right[i] - factor * right[i - 1];
      corner[i] -= factor * corner[i - 1];
    }
    for (std::size_t i = count; i-- > 0 && !looks_.stopped();) {
      const bool end = i + 1 == count;
      slopes_[i] = (right[i] - (end ? Vector{} : upper[i] * slopes_[i + 1])) / middle[i];
      corner[i] = (corner[i] - (end ? 0 : upper[i] * corner[i + 1])) / middle[i];
    }
    if (!closed_) return;
    const double share = -lower[0] / 2;
    const Vector excess = (slopes_[0] + share * slopes_[count - 1]) / (1 + corner[0] + share * corner[count - 1]);
    for (std::size_t i = 0; i < count && !looks_.stopped(); ++i) slopes_[i] = slopes_[i] - corner[i] * excess;
  }

  std::vector<Vector> points_;
  bool closed_;
  std::vector<double> steps_;   ///< of the parameter, by piece
  std::vector<Vector> rates_;   ///< chord by step, by piece
  std::vector<Vector> slopes_;  ///< by knot
  CancelEvery looks_;
};

/// Lengths of a curve from its start to even places on its pieces.
class Lengths {
 public:
  Lengths(const Spline& spline, const Cancel& cancel) : sums_(spline.pieces() * looks_per_piece + 1) {
    CancelEvery looks(cancel);
    Vector last = spline.at(0, 0);
    for (std::size_t k = 1; k < sums_.size() && !looks.stopped(); ++k) {
      const auto [piece, share] = place(static_cast<double>(k));
      const Vector here = spline.at(piece, share);
      sums_[k] = sums_[k - 1] + length(here - last);
      last = here;
    }
  }

  double total() const { return sums_.back(); }

  /// The piece and the share of it at a length.
  std::pair<std::size_t, double> at(double wanted) const {
    const auto above = std::upper_bound(sums_.begin() + 1, sums_.end() - 1, wanted);
    const auto k = static_cast<std::size_t>(above - sums_.begin());
    const double step = sums_[k] - sums_[k - 1];
    const double share = step > 0 ? std::clamp((wanted - sums_[k - 1]) / step, 0.0, 1.0) : 0;
    return place(static_cast<double>(k - 1) + share);
  }

 private:
  static constexpr std::size_t looks_per_piece = 64;

  std::pair<std::size_t, double> place(double look) const {
    const double pieces = look / looks_per_piece;
    const auto piece = std::min(static_cast<std::size_t>(pieces), (sums_.size() - 1) / looks_per_piece - 1);
    return {piece, pieces - static_cast<double>(piece)};
  }

  std::vector<double> sums_;
};

std::vector<Vector> distinct_points(const Column<Point>& given, bool closed, CancelEvery& looks) {
  const SamePlace agree(given, looks);
  std::vector<Vector> points;
  for (std::size_t i = 0; i < given.size() && !looks.stopped(); ++i) {
    const Vector place = to_vector(given[i]);
    if (points.empty() || !agree(place, points.back())) points.push_back(place);
  }
  while (closed && points.size() > 1 && agree(points.back(), points.front())) points.pop_back();
  return points;
}

}  // namespace

Column<Point> spline_points(const Column<Point>& given, const SplineOptions& options, const Cancel& cancel) {
  CancelEvery looks(cancel);
  std::vector<Vector> points = distinct_points(given, options.closed, looks);
  if (points.empty()) return {};
  Column<Point> result(options.count);
  if (points.size() == 1) {
    for (std::size_t i = 0; i < options.count && !looks.stopped(); ++i) result.set(i, to_point(points.front()));
    return result;
  }
  const Spline spline(std::move(points), options.closed, options.kind, cancel);
  if (cancel.stopped()) return result;
  const auto pieces = static_cast<double>(spline.pieces());
  if (options.spacing == SplineSpacing::points) {
    const Column<double> places = spaced(0, pieces, options.count, options.closed, cancel);
    for_chunks(cancel, options.count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto piece = std::min(static_cast<std::size_t>(places[i]), spline.pieces() - 1);
        result.set(i, to_point(spline.at(piece, places[i] - static_cast<double>(piece))));
      }
    });
    return result;
  }
  const Lengths lengths(spline, cancel);
  const Column<double> places = spaced(0, lengths.total(), options.count, options.closed, cancel);
  for_chunks(cancel, options.count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto [piece, share] = lengths.at(places[i]);
      result.set(i, to_point(spline.at(piece, share)));
    }
  });
  return result;
}

}  // namespace dini

#include "geometry/curve_pieces.h"

#include <optional>

#include "geometry/clip.h"

namespace dini {

namespace {

/// A curve with a limit on how far it may go.
class ClippedCurve {
 public:
  ClippedCurve(const Polyline& curve, double clip_radius, const Cancel& cancel)
      : curve_(curve),
        cancel_(cancel),
        clip_radius_(clip_radius),
        count_(curve.points.size()),
        closed_(curve.closed && count_ >= 3) {
    double largest = 0;
    CancelEvery steps(cancel_);
    for (std::size_t i = 0; i < count_ && !steps.stopped(); ++i) {
      if (inside(i)) largest = std::max(largest, largest_component(point(i)));
    }
    tolerance_ = relative_round_off * largest;
  }

  std::vector<CurvePiece> pieces() const {
    if (count_ == 0) return {};
    const std::optional<std::size_t> gap = first_gap();
    if (closed_ && !gap) return with_enough_points({closed_piece()});
    // A closed curve is unrolled from behind its first gap.
    const std::size_t start = closed_ ? (*gap + 1) % count_ : 0;
    std::vector<CurvePiece> pieces(1);
    if (closed_ && !holds_infinity(*gap)) append_cut(pieces.back(), start, *gap);
    CancelEvery steps(cancel_);
    for (std::size_t k = 0; k < count_ && !steps.stopped(); ++k) {
      const std::size_t i = (start + k) % count_;
      if (inside(i)) append(pieces.back(), point(i));
      if (k + 1 == count_ && !closed_) break;
      const std::size_t next = (i + 1) % count_;
      if (joined(i)) continue;
      if (!holds_infinity(i)) append_cut(pieces.back(), i, next);
      pieces.emplace_back();
      if (!holds_infinity(i)) append_cut(pieces.back(), next, i);
    }
    return with_enough_points(std::move(pieces));
  }

 private:
  Vector point(std::size_t i) const { return to_vector(curve_.points[i]); }
  bool inside(std::size_t i) const { return is_finite(point(i)) && length(point(i)) <= clip_radius_; }

  /// The step from point i to the next one; nothing beyond an open end or at infinity.
  std::optional<Vector> step(std::size_t i) const {
    if (!closed_ && i + 1 >= count_) return {};
    const Vector from = point(i), to = point((i + 1) % count_);
    if (!is_finite(from) || !is_finite(to)) return {};
    return to - from;
  }

  /// Whether the curve goes through infinity between point i and the next one. On a line through infinity that step
  /// runs against its neighbors and covers both of them.
  bool holds_infinity(std::size_t i) const {
    const std::optional<Vector> here = step(i);
    if (!here || !(length(*here) > ordinary_step * clip_radius_)) return false;
    const std::optional<Vector> before = i > 0 || closed_ ? step((i + count_ - 1) % count_) : std::nullopt;
    const std::optional<Vector> after = i + 1 < count_ || closed_ ? step((i + 1) % count_) : std::nullopt;
    if (!before && !after) return false;
    if (length(*here) <= length(before ? *before : *after) + length(after ? *after : *before)) return false;
    return (!before || opposes(*before, *here)) && (!after || opposes(*here, *after));
  }

  bool joined(std::size_t i) const { return inside(i) && inside((i + 1) % count_) && !holds_infinity(i); }

  std::optional<std::size_t> first_gap() const {
    CancelEvery steps(cancel_);
    for (std::size_t i = 0; i < count_ && !steps.stopped(); ++i) {
      if (!joined(i)) return i;
    }
    return {};
  }

  void append(CurvePiece& piece, const Vector& position) const {
    if (piece.points.empty() || largest_component(position - piece.points.back()) > tolerance_) {
      piece.points.push_back(position);
    }
  }

  /// Where the way from an inside point to an outside one leaves the sphere.
  void append_cut(CurvePiece& piece, std::size_t from, std::size_t to) const {
    if (!inside(from) || inside(to) || !is_finite(point(to))) return;
    const Vector direction = normalized(point(to) - point(from));
    append(piece, point(from) + length_to_sphere(point(from), direction, clip_radius_) * direction);
  }

  CurvePiece closed_piece() const {
    CurvePiece piece;
    CancelEvery steps(cancel_);
    for (std::size_t i = 0; i < count_ && !steps.stopped(); ++i) append(piece, point(i));
    while (piece.points.size() > 1 && largest_component(piece.points.back() - piece.points.front()) <= tolerance_) {
      piece.points.pop_back();
    }
    piece.closed = piece.points.size() >= 3;
    return piece;
  }

  static std::vector<CurvePiece> with_enough_points(std::vector<CurvePiece> pieces) {
    std::erase_if(pieces, [](const CurvePiece& piece) { return piece.points.size() < 2; });
    return pieces;
  }

  const Polyline& curve_;
  const Cancel& cancel_;
  double clip_radius_;
  std::size_t count_;
  bool closed_;
  double tolerance_ = 0;
};

}  // namespace

std::vector<CurvePiece> curve_pieces(const Polyline& curve, double clip_radius, const Cancel& cancel) {
  return ClippedCurve(curve, std::min(clip_radius, largest_clip_radius), cancel).pieces();
}

}  // namespace dini

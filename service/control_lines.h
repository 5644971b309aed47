#pragma once

#include <vector>

#include "algebra/extract.h"
#include "geometry/cancel.h"
#include "geometry/mesh.h"
#include "service/preview_frame.h"

namespace dini {

/// Straight and round lines that control geometry is made of, in proportion to a frame. What leaves the reach of the
/// frame is cut there. Stopped early: some lines are not whole.
class ControlLines {
 public:
  ControlLines(const PreviewFrame& frame, const Cancel& cancel) : frame_(frame), cancel_(cancel) {}

  void segment(const Vector& from, const Vector& to);
  /// Along `by`, at most as far as the frame reaches and never too short to be seen; a zero vector draws nothing.
  void arrow(const Vector& from, const Vector& by);
  /// Three short lines that meet at a place.
  void cross_mark(const Vector& at);
  /// A circle, or the part of a line within the frame; `dashed` leaves out every other piece.
  void round(const CircleCoordinates& circle, bool dashed = false);
  /// An arrow that runs around three quarters of a circle, counter-clockwise about the normal.
  void turn_mark(const Vector& center, const Vector& normal, double radius);
  /// The pieces of a curve within the frame.
  void curve(const Polyline& curve);

  const PreviewFrame& frame() const { return frame_; }
  std::vector<Polyline> take() { return std::move(lines_); }

 private:
  void strip(const std::vector<Vector>& points, bool closed = false);
  void arrow_head(const Vector& tip, const Vector& along, double size);
  void line(const CircleCoordinates& line);

  const PreviewFrame& frame_;
  const Cancel& cancel_;
  std::vector<Polyline> lines_;
};

}  // namespace dini

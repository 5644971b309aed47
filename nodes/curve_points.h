#pragma once

#include "geometry/validate.h"
#include "graph/arguments.h"
#include "graph/context.h"

namespace dini {

/// The points of a curve that an input `port` is given; a failure where one is farther than a mesh may be, which is
/// "point 7" and what `fault` says of it. Stopped early: some of them.
inline Attempt<Column<Point>> points_of_curve(const Context& context, const Block<Point, 1>& given, const char* port,
                                              const std::string& fault) {
  Column<Point> points(given.size());
  CancelEvery looks(context.cancel());
  for (std::size_t i = 0; i < given.size() && !looks.stopped(); ++i) {
    const Point point = given(i);
    if (!is_within_reach(point)) {
      return Failure{"degenerate", "point " + std::to_string(i) + fault, port};
    }
    points.set(i, point);
  }
  return points;
}

}  // namespace dini

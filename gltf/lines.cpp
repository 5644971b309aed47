#include "gltf/lines.h"

#include "geometry/validate.h"

namespace dini {
namespace {

std::array<float, 3> to_float(const Point& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

}  // namespace

void add_drawable_runs(const Polyline& polyline, FloatRuns& runs, const Cancel& cancel) {
  const std::size_t size = polyline.points.size();
  CancelEvery steps(cancel);
  std::size_t start = 0;  // where a closed polyline is opened: after a gap, so that no run crosses its start
  if (polyline.closed) {
    while (start < size && is_within_reach(polyline.points[start]) && !steps.stopped()) ++start;
    if (start == size) start = 0;
  }
  std::size_t first = runs.points.size();
  const auto finish_run = [&] {
    if (runs.points.size() < first + 2) runs.points.resize(first);
    if (runs.points.size() > first) runs.ends.push_back(runs.points.size());
    first = runs.points.size();
  };
  for (std::size_t i = 0; i < size && !steps.stopped(); ++i) {
    const Point point = polyline.points[(start + i) % size];
    if (is_within_reach(point)) {
      runs.points.push_back(to_float(point));
    } else {
      finish_run();
    }
  }
  const bool whole = runs.points.size() == first + size;
  if (polyline.closed && whole && size > 1) runs.points.push_back(std::array(runs.points[first]));
  finish_run();
}

FloatPoints drawable_points(const Column<Point>& points, const Cancel& cancel) {
  FloatPoints result;
  result.reserve(points.size());
  CancelEvery steps(cancel);
  for (std::size_t i = 0; i < points.size() && !steps.stopped(); ++i) {
    const Point point = points[i];
    if (is_within_reach(point)) result.push_back(to_float(point));
  }
  return result;
}

}  // namespace dini

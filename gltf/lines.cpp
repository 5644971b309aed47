#include "gltf/lines.h"

#include <utility>

#include "geometry/validate.h"

namespace dini {
namespace {

std::array<float, 3> to_float(const Point& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

}  // namespace

std::vector<FloatPoints> drawable_runs(const Polyline& polyline) {
  const std::size_t size = polyline.points.size();
  std::size_t start = 0;  // where a closed polyline is opened: after a gap, so that no run crosses its start
  if (polyline.closed) {
    while (start < size && is_within_reach(polyline.points[start])) ++start;
    if (start == size) start = 0;
  }
  std::vector<FloatPoints> runs;
  FloatPoints run;
  const auto finish_run = [&] {
    if (run.size() > 1) runs.push_back(std::move(run));
    run.clear();
  };
  for (std::size_t i = 0; i < size; ++i) {
    const Point point = polyline.points[(start + i) % size];
    if (is_within_reach(point)) {
      run.push_back(to_float(point));
    } else {
      finish_run();
    }
  }
  if (polyline.closed && run.size() == size && size > 1) run.push_back(run.front());
  finish_run();
  return runs;
}

FloatPoints drawable_points(const Column<Point>& points) {
  FloatPoints result;
  result.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point point = points[i];
    if (is_within_reach(point)) result.push_back(to_float(point));
  }
  return result;
}

}  // namespace dini

#include "nodes/drawn_scene.h"

#include <algorithm>
#include <map>

#include "algebra/extract.h"
#include "geometry/circle_grid.h"
#include "geometry/validate.h"

namespace dini {

namespace {

constexpr double line_extent = 20;  ///< meters of a line that are drawn
constexpr std::size_t fewest_circle_segments = 16;
constexpr std::size_t circle_points = 4'000'000;  ///< of all circles together, as long as none gets too coarse

Polyline drawn(const Circle& circle, std::size_t segments, const Cancel& cancel) {
  const std::optional<CircleCoordinates> found = coordinates(circle);
  if (!found) return {};
  if (!found->line) return {sample_circle_row({*found}, segments, false, found->radius, cancel), true};
  Polyline line{Column<Point>(2), false};
  line.points.set(0, point_at(*found, -0.5, line_extent));
  line.points.set(1, point_at(*found, 0.5, line_extent));
  return line;
}

/// "[3,0]" for the sample `index` of a family over `axes`; nothing for a single value.
std::string place_of(const Axes& axes, std::size_t index) {
  std::string text;
  for (std::size_t k = axes.size(); k-- > 0;) {
    text = std::to_string(index % axes[k].size) + (text.empty() ? "" : ",") + text;
    index /= axes[k].size;
  }
  return text.empty() ? "" : "[" + text + "]";
}

/// Names of models for parts: the same model given twice gets a number behind its name, so that no two are alike. No
/// output of a node is called by a number, so ".2" means nothing else.
class PartNames {
 public:
  std::string unique(const std::string& name) {
    const std::size_t times = ++times_[name];
    return times == 1 ? name : name + "." + std::to_string(times);
  }

 private:
  std::map<std::string, std::size_t> times_;
};

}  // namespace

std::size_t segments_of_circles(std::size_t circles) {
  return std::clamp(circle_points / std::max<std::size_t>(1, circles), fewest_circle_segments, usual_circle_segments);
}

std::size_t count_circles(const Items& models) {
  std::size_t count = 0;
  for (const Value& value : models.values) count += value.type() == WireType::circle ? sample_count(value.axes) : 0;
  return count;
}

Scene scene_of(const Items& models, const Cancel& cancel) {
  Scene scene;
  const std::size_t segments = segments_of_circles(count_circles(models));
  CancelEvery steps(cancel);
  PartNames names;
  for (std::size_t k = 0; k < models.values.size(); ++k) {
    const Value& value = models.values[k];
    const std::string& material = models.origins[k].part;
    const std::string name = names.unique(material);
    if (value.type() == WireType::mesh) {
      const Column<SharedMesh>& meshes = column_of<SharedMesh>(value);
      for (std::size_t i = 0; i < meshes.size() && !steps.stopped(); ++i) {
        scene.parts.push_back({name + place_of(value.axes, i), meshes[i], meshes[i]->color, material});
      }
    } else if (value.type() == WireType::circle) {
      const auto& circles = std::get<SharedColumn<Circle>>(value.column);
      const auto curve = [circles, segments, &cancel](std::size_t i) { return drawn((*circles)[i], segments, cancel); };
      scene.parts.push_back({name, CurveSource{circles->size(), curve}, linear_color(WireType::circle), material});
    } else {
      scene.parts.push_back(
          {name, std::get<SharedColumn<Point>>(value.column), linear_color(WireType::point), material});
    }
  }
  return scene;
}

std::size_t count_out_of_reach(const Value& value, const Cancel& cancel) {
  std::size_t count = 0;
  CancelEvery steps(cancel);
  if (value.type() == WireType::point) {
    const Column<Point>& points = column_of<Point>(value);
    for (std::size_t i = 0; i < points.size() && !steps.stopped(); ++i) count += is_within_reach(points[i]) ? 0 : 1;
  } else if (value.type() == WireType::circle) {
    const Column<Circle>& circles = column_of<Circle>(value);
    for (std::size_t i = 0; i < circles.size() && !steps.stopped(); ++i) {
      const std::optional<CircleCoordinates> found = coordinates(circles[i]);
      count += found && is_within_reach(found->line ? found->point : found->center) ? 0 : 1;
    }
  }
  return count;
}

}  // namespace dini

#include "service/preview_parts.h"

#include <algorithm>
#include <map>

#include "algebra/extract.h"
#include "graph/offsets.h"
#include "service/control_lines.h"
#include "service/generator_lines.h"

namespace dini {

namespace {

class Drawing {
 public:
  Drawing(const PreviewedOutput& output, const PreviewFrame& frame, const Limits& limits, std::size_t points,
          const Cancel& cancel)
      : output_(output),
        frame_(frame),
        limits_(limits),
        points_(points),
        color_(linear_color(output.value.type())),
        cancel_(cancel) {}

  std::vector<GlbChild> run() {
    std::visit([this]<class T>(const std::shared_ptr<const Column<T>>& column) { draw(*column); },
               output_.value.column);
    return std::move(children_);
  }

 private:
  void draw(const Column<double>&) {}
  void draw(const Column<SharedFile>&) {}
  void draw(const Column<SharedField>&) {}

  void draw(const Column<SharedMesh>& meshes) {
    const std::vector<std::size_t> shown = spread_indices(meshes.size(), limits_.preview_elements);
    GlbChild& child = add_child(meshes.size(), shown.size());
    for (const std::size_t i : shown) child.parts.push_back({"", meshes[i], meshes[i]->color});
  }

  void draw(const Column<Point>& points) {
    if (output_.curve_axis) return draw_curves(points);
    const std::vector<std::size_t> chosen = spread_indices(points.size(), limits_.preview_points);
    Column<Point> shown(chosen.size());
    std::size_t count = 0;
    for (const std::size_t i : chosen) {
      if (length(to_vector(points[i])) <= frame_.reach) shown.set(count++, points[i]);
    }
    auto within = std::make_shared<Column<Point>>(count);
    for (std::size_t i = 0; i < count; ++i) within->set(i, shown[i]);
    add_child(points.size(), count).parts.push_back({"", SharedColumn<Point>(within), color_});
  }

  /// One line along the curve axis for every index of the others.
  void draw_curves(const Column<Point>& points) {
    const Axes& axes = output_.value.axes;
    const Axis& along = axes[*output_.curve_axis];
    const std::size_t stride = stride_of(axes, along.name);
    const std::size_t count = along.size == 0 ? 0 : points.size() / along.size;
    const std::vector<std::size_t> shown = spread_indices(count, limits_.preview_elements);
    const std::size_t each = std::max<std::size_t>(2, points_ / std::max<std::size_t>(1, shown.size()));
    ControlLines lines(frame_, cancel_);
    for (const std::size_t curve : shown) {
      if (cancel_.stopped()) break;
      const std::size_t base = curve / stride * stride * along.size + curve % stride;
      const std::vector<std::size_t> kept = spread_indices(along.size, each);
      Polyline line{Column<Point>(kept.size()), along.closed};
      for (std::size_t i = 0; i < kept.size(); ++i) line.points.set(i, points[base + kept[i] * stride]);
      lines.curve(line);
    }
    add_lines(count, shown.size(), lines);
  }

  void draw(const Column<Circle>& circles) {
    draw_each(circles, [](const Circle& circle, ControlLines& lines) {
      if (const auto found = coordinates(circle)) lines.round(*found);
    });
  }

  void draw(const Column<Vector>& vectors) {
    draw_each(vectors, [](const Vector& vector, ControlLines& lines) { lines.arrow({}, vector); });
  }

  void draw(const Column<Sphere>& spheres) {
    draw_each(spheres, [](const Sphere& sphere, ControlLines& lines) {
      const auto found = coordinates(sphere);
      if (!found) return;
      found->plane ? draw_plane(*found, lines) : draw_sphere(*found, lines);
    });
  }

  static void draw_sphere(const SphereCoordinates& sphere, ControlLines& lines) {
    for (const Vector& normal : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
      CircleCoordinates equator;
      equator.center = sphere.center;
      equator.normal = normal;
      equator.radius = sphere.radius;
      lines.round(equator);
    }
  }

  /// A square about the place nearest the middle of the frame, and the normal.
  static void draw_plane(const SphereCoordinates& plane, ControlLines& lines) {
    const PreviewFrame& frame = lines.frame();
    const double above = dot(frame.center, plane.normal) - plane.distance;
    const Vector middle = frame.center - above * plane.normal;
    const Vector u = (1.5 * frame.size) * any_perpendicular(plane.normal), v = cross(plane.normal, u);
    lines.segment(middle + u, middle + v);
    lines.segment(middle + v, middle - u);
    lines.segment(middle - u, middle - v);
    lines.segment(middle - v, middle + u);
    lines.arrow(middle, (0.4 * frame.size) * plane.normal);
  }

  void draw(const Column<Generator>& generators) {
    const std::vector<std::size_t> shown = spread_indices(generators.size(), limits_.preview_elements);
    std::map<GeneratorKind, std::vector<std::size_t>> kinds;
    for (const std::size_t i : shown) kinds[kind_of(generators[i])].push_back(i);
    for (const auto& [kind, members] : kinds) {
      ControlLines lines(frame_, cancel_);
      for (const std::size_t i : members) dini::draw(generators[i], kind, lines);
      add_lines(generators.size(), members.size(), lines);
      children_.back().extras["kind"] = word_for(kind);
    }
  }

  template <class T, class Draw>
  void draw_each(const Column<T>& column, const Draw& draw_one) {
    const std::vector<std::size_t> shown = spread_indices(column.size(), limits_.preview_elements);
    ControlLines lines(frame_, cancel_);
    for (const std::size_t i : shown) draw_one(column[i], lines);
    add_lines(column.size(), shown.size(), lines);
  }

  GlbChild& add_child(std::size_t count, std::size_t drawn) {
    children_.push_back(
        {output_.name,
         {{"output", output_.name}, {"type", name(output_.value.type())}, {"count", count}, {"drawn", drawn}},
         {}});
    return children_.back();
  }

  void add_lines(std::size_t count, std::size_t drawn, ControlLines& lines) {
    add_child(count, drawn).parts.push_back({"", lines.take(), color_});
  }

  const PreviewedOutput& output_;
  const PreviewFrame& frame_;
  const Limits& limits_;
  const std::size_t points_;
  const Color color_;  ///< of the socket
  const Cancel& cancel_;
  std::vector<GlbChild> children_;
};

}  // namespace

std::vector<GlbChild> drawn_parts(const PreviewedOutput& output, const PreviewFrame& frame, const Limits& limits,
                                  std::size_t points, const Cancel& cancel) {
  return Drawing(output, frame, limits, points, cancel).run();
}

}  // namespace dini

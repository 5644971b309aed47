#include <algorithm>
#include <charconv>
#include <cmath>

#include "algebra/extract.h"
#include "geometry/circle_grid.h"
#include "geometry/validate.h"
#include "gltf/glb_writer.h"
#include "graph/literal.h"
#include "graph/node_builder.h"
#include "nodes/all.h"

namespace dini {

namespace {

constexpr std::size_t circle_segments = 256;
constexpr double line_extent = 20;                    ///< meters of a line that are drawn
constexpr int draft_speed = 7;                        ///< At least: faster levels gain little time and double the size.
constexpr double root_of_three = 1.7320508075688772;  ///< From an error per axis to a distance.
constexpr Color curve_color = {0.95, 0.69, 0.13, 1};
constexpr Color point_color = {0.95, 1.0, 0.44, 1};

Polyline drawn(const CircleCoordinates& circle) {
  if (!circle.line) return {sample_circle_row({circle}, circle_segments, false, circle.radius), true};
  Polyline line{Column<Point>(2), false};
  line.points.set(0, point_at(circle, -0.5, line_extent));
  line.points.set(1, point_at(circle, 0.5, line_extent));
  return line;
}

std::vector<Polyline> drawn(const Column<Circle>& circles) {
  std::vector<Polyline> curves;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const std::optional<CircleCoordinates> found = coordinates(circles[i]);
    if (found) curves.push_back(drawn(*found));
  }
  return curves;
}

/// Parts are named by their place, not by node ids: ids do not count in a result.
Scene scene_of(const std::vector<Value>& models) {
  Scene scene;
  for (const Value& value : models) {
    const std::string name = "model " + std::to_string(scene.parts.size() + 1);
    if (value.type() == WireType::mesh) {
      const Column<SharedMesh>& meshes = column_of<SharedMesh>(value);
      for (std::size_t i = 0; i < meshes.size(); ++i) {
        const std::string place = meshes.size() > 1 ? ", " + std::to_string(i + 1) : "";
        scene.parts.push_back({name + place, meshes[i], meshes[i]->color});
      }
    } else if (value.type() == WireType::circle) {
      scene.parts.push_back({name, drawn(column_of<Circle>(value)), curve_color});
    } else {
      scene.parts.push_back({name, column_of<Point>(value), point_color});
    }
  }
  return scene;
}

/// What of a value no file can hold: points and circles at infinity, or farther than any coordinate may be.
std::size_t count_out_of_reach(const Value& value) {
  std::size_t count = 0;
  if (value.type() == WireType::point) {
    const Column<Point>& points = column_of<Point>(value);
    for (std::size_t i = 0; i < points.size(); ++i) count += is_within_reach(points[i]) ? 0 : 1;
  } else if (value.type() == WireType::circle) {
    const Column<Circle>& circles = column_of<Circle>(value);
    for (std::size_t i = 0; i < circles.size(); ++i) {
      const std::optional<CircleCoordinates> found = coordinates(circles[i]);
      count += found && is_within_reach(found->line ? found->point : found->center) ? 0 : 1;
    }
  }
  return count;
}

void warn_of_what_is_left_out(const Context& context, const std::vector<Value>& models) {
  for (std::size_t k = 0; k < models.size(); ++k) {
    const std::size_t count = count_out_of_reach(models[k]);
    if (count == 0) continue;
    context.warn({"at-infinity",
                  std::to_string(count) + " of " + std::to_string(sample_count(models[k].axes)) + " " +
                      std::string(name(models[k].type())) + "s of model " + std::to_string(k + 1) +
                      " are at infinity or beyond 1e18 m, and not in the file",
                  "model"});
  }
}

std::string two_digits(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof(text), value, std::chars_format::general, 2).ptr};
}

/// Tells the part whose texture coordinates lose the most to rounding, and how many lose much.
void warn_of_rough_uvs(const Context& context, const std::vector<RoughUvs>& rough) {
  if (rough.empty()) return;
  const RoughUvs& worst = *std::max_element(rough.begin(), rough.end(),
                                            [](const RoughUvs& a, const RoughUvs& b) { return a.error < b.error; });
  context.warn({"imprecise",
                "the texture coordinates of " + worst.part + " reach from " + to_text(worst.minimum) + " to " +
                    to_text(worst.maximum) + " and are rounded by up to " + two_digits(worst.error) +
                    ", where 1 is the size of the picture" +
                    (rough.size() == 1 ? "" : "; so are those of " + std::to_string(rough.size() - 1) + " more"),
                "model"});
}

/// Why there is nothing to write, model by model.
Failure nothing_to_draw(const std::vector<Value>& models) {
  std::string reasons;
  for (std::size_t k = 0; k < models.size(); ++k) {
    const bool mesh = models[k].type() == WireType::mesh;
    reasons += (k == 0 ? "" : ", ") + std::string("model ") + std::to_string(k + 1) +
               (mesh ? " has no triangles that are larger than the round-off at their place"
                     : " has nothing nearer than 1e18 m");
    if (k == 2 && models.size() > 3)
      return {"encode-failed", "there is nothing to draw: " + reasons + ", and so on", "model"};
  }
  return {"encode-failed", "there is nothing to draw: " + reasons, "model"};
}

Failure failure_of(const EncodeError& error) {
  const std::string part = error.part.empty() ? "" : error.part + ": ";
  switch (error.code) {
    case EncodeError::Code::non_finite:
      return {"non-finite", part + error.detail, "model"};
    case EncodeError::Code::too_large:
      return {"limit-exceeded", part + error.detail, "model"};
    case EncodeError::Code::empty:
    case EncodeError::Code::invalid_input:
    case EncodeError::Code::encoder_failed:
    case EncodeError::Code::cancelled:
      break;
  }
  return {"encode-failed", part + error.detail, "model"};
}

Attempt<SharedAsset> export_glb(const Context& context,
                                const Several<WireType::mesh, WireType::point, WireType::circle>& model,
                                std::int64_t position_bits, std::int64_t normal_bits, std::int64_t speed,
                                bool normals) {
  EncodeOptions options;
  options.position_bits = static_cast<int>(position_bits);
  options.normal_bits = static_cast<int>(normal_bits);
  options.speed = static_cast<int>(speed);
  if (context.quality() == Quality::draft) options.speed = std::max(options.speed, draft_speed);
  options.normals = normals;
  EncodeResult<EncodedScene> encoded = encode_scene(scene_of(model.values), options, context.cancel());
  if (const auto* error = std::get_if<EncodeError>(&encoded)) {
    return error->code == EncodeError::Code::empty ? nothing_to_draw(model.values) : failure_of(*error);
  }
  EncodedScene& scene = std::get<EncodedScene>(encoded);
  warn_of_what_is_left_out(context, model.values);
  warn_of_rough_uvs(context, scene.rough_uvs);
  for (const std::string& part : scene.empty_parts) context.warn({"empty", part + " has nothing to draw", "model"});
  return std::make_shared<const Asset>(Asset{"model/gltf-binary", std::move(scene.glb), scene.vertices, scene.triangles,
                                             root_of_three * scene.position_error});
}

}  // namespace

void add_export(Registry& registry) {
  registry.add(node("export", export_glb)
                   .title("Export")
                   .family("answers")
                   .doc("Writes meshes, circles and points as one Draco-compressed glTF file.")
                   .details("Everything shares one quantization grid, so seams never crack. Circles and points travel "
                            "uncompressed. Graphs are Z up; the file's root node turns to Y up.")
                   .input("model", "Meshes, circles or points, over any axes.", required().several())
                   .input("position_bits", "Bits per coordinate over the largest extent.", defaults(14).hard(8, 20))
                   .input("normal_bits", "Bits per normal coordinate.", defaults(10).hard(6, 16))
                   .input("speed", "0 smallest file, 10 fastest.", defaults(7).hard(0, 10))
                   .input("normals", "Whether normals are sent.", defaults(true))
                   .depends_on_quality()
                   .output("asset", "The file."));
}

}  // namespace dini

#include <algorithm>
#include <charconv>
#include <cmath>

#include "gltf/encode_cost.h"
#include "gltf/glb_writer.h"
#include "graph/literal.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/drawn_scene.h"

namespace dini {

namespace {

constexpr int draft_speed = 7;                        ///< At least: faster levels gain little time and double the size.
constexpr double root_of_three = 1.7320508075688772;  ///< From an error per axis to a distance.

void warn_of_what_is_left_out(const Context& context, const Items& models) {
  for (std::size_t k = 0; k < models.values.size(); ++k) {
    const Value& value = models.values[k];
    const std::size_t count = count_out_of_reach(value, context.cancel());
    if (count == 0) continue;
    context.warn({"at-infinity",
                  std::to_string(count) + " of " + std::to_string(sample_count(value.axes)) + " " +
                      std::string(name(value.type())) + "s of " + models.origins[k].part +
                      " are at infinity or beyond 1e18 m, and not in the file",
                  "model"});
  }
}

void warn_of_coarse_circles(const Context& context, const Items& models) {
  const std::size_t circles = count_circles(models);
  const std::size_t segments = segments_of_circles(circles);
  if (segments == usual_circle_segments) return;
  context.warn({"coarse",
                std::to_string(circles) + " circles are too many to draw each in " +
                    std::to_string(usual_circle_segments) + " segments; they have " + std::to_string(segments),
                "model"});
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

/// Why there is nothing to write, model by model, and what could be changed.
Failure nothing_to_export(const Items& models) {
  constexpr std::size_t most_named = 3;
  std::string reasons;
  for (std::size_t k = 0; k < std::min(models.values.size(), most_named); ++k) {
    const bool mesh = models.values[k].type() == WireType::mesh;
    reasons += (k == 0 ? "" : "; ") + models.origins[k].description +
               (mesh ? ", has no triangles that are larger than the round-off at their place"
                     : ", has nothing nearer than 1e18 m");
  }
  if (models.values.size() > most_named) reasons += "; and so on";
  return {"nothing-to-export", "there is nothing to draw: " + reasons + "; change what they depend on, or their inputs",
          "model"};
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
    case EncodeError::Code::canceled:
      break;
  }
  return {"encode-failed", part + error.detail, "model"};
}

RunCost cost_of_export(const RunSize& size) {
  const double circles = size.given_of(WireType::circle);
  const auto segments = static_cast<double>(segments_of_circles(static_cast<std::size_t>(circles)));
  const DrawnSizes drawn{size.given_of(WireType::mesh), size.given_vertices, circles, segments * circles,
                         size.given_of(WireType::point)};
  const EncodeCost cost = encode_cost(drawn, static_cast<int>(integer_at(size.literals, "speed")));
  return {cost.work, cost.bytes, cost.file_bytes};
}

struct ExportInputs {
  std::int64_t position_bits, normal_bits, speed;
  bool normals;
};

Attempt<SharedAsset> export_glb(const Context& context,
                                const Several<WireType::mesh, WireType::point, WireType::circle>& model,
                                const ExportInputs& in) {
  EncodeOptions options;
  options.position_bits = static_cast<int>(in.position_bits);
  options.normal_bits = static_cast<int>(in.normal_bits);
  options.speed = static_cast<int>(in.speed);
  if (context.quality() == Quality::draft) options.speed = std::max(options.speed, draft_speed);
  options.normals = in.normals;
  EncodeResult<EncodedScene> encoded = encode_scene(scene_of(model, context.cancel()), options, context.cancel());
  if (!encoded) {
    const EncodeError& error = encoded.error();
    return error.code == EncodeError::Code::empty ? nothing_to_export(model) : failure_of(error);
  }
  EncodedScene& scene = *encoded;
  warn_of_what_is_left_out(context, model);
  warn_of_coarse_circles(context, model);
  warn_of_rough_uvs(context, scene.rough_uvs);
  for (const std::string& part : scene.empty_parts) context.warn({"empty", part + " has nothing to draw", "model"});
  return std::make_shared<const Asset>(Asset{"model/gltf-binary", std::move(scene.glb), scene.vertices, scene.triangles,
                                             root_of_three * scene.position_error});
}

}  // namespace

void add_export(Registry& registry) {
  registry.add(
      node("export", export_glb)
          .title("Export")
          .family("answers")
          .doc("Writes meshes, circles and points as one Draco-compressed glTF file.")
          .details("Everything shares one quantization grid, so seams never crack. Circles and points travel "
                   "uncompressed; of more than 15 625 circles each has fewer than the usual 256 segments. "
                   "Parts and materials have the ids of the nodes that made them. Graphs are Z up; the "
                   "file's root node turns to Y up.")
          .input("model", "Meshes, circles or points, over any axes.", required().several())
          .input("position_bits", &ExportInputs::position_bits, "Bits per coordinate over the largest extent.",
                 defaults(14).hard(8, 20))
          .input("normal_bits", &ExportInputs::normal_bits, "Bits per normal coordinate.", defaults(10).hard(6, 16))
          .input("speed", &ExportInputs::speed, "0 smallest file, 10 fastest.", defaults(7).hard(0, 10))
          .input("normals", &ExportInputs::normals, "Whether normals are sent.", defaults(true))
          .depends_on_quality()
          .names_parts()
          .cost(cost_of_export)
          .output("asset", "The file."));
}

}  // namespace dini

#include <algorithm>

#include "gltf/encode_cost.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/drawn_scene.h"
#include "nodes/formats.h"

namespace dini {

namespace {

constexpr int draft_speed = 7;  ///< At least: faster levels gain little time and double the size.

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

RunCost cost_of_export(const RunSize& size) {
  const double circles = size.given_of(WireType::circle);
  const auto segments = static_cast<double>(segments_of_circles(static_cast<std::size_t>(circles)));
  const DrawnSizes drawn{size.given_of(WireType::mesh), size.given_vertices, circles, segments * circles,
                         size.given_of(WireType::point)};
  const EncodeCost cost =
      encode_cost(drawn, static_cast<int>(integer_at(size.literals, "speed")), boolean_at(size.literals, "draco"));
  return {cost.work, cost.bytes, cost.file_bytes};
}

struct ExportInputs {
  std::int64_t position_bits, normal_bits, uv_bits, speed;
  bool normals, draco;
};

Attempt<SharedFile> export_file(const Context& context,
                                const Several<WireType::mesh, WireType::point, WireType::circle>& model,
                                const ExportInputs& in) {
  FileOptions options;
  options.position_bits = static_cast<int>(in.position_bits);
  options.normal_bits = static_cast<int>(in.normal_bits);
  options.uv_bits = static_cast<int>(in.uv_bits);
  options.speed = static_cast<int>(in.speed);
  if (context.quality() == Quality::draft) options.speed = std::max(options.speed, draft_speed);
  options.normals = in.normals;
  const WantedFile* const wanted = context.file();
  options.draco = in.draco && (wanted == nullptr || wanted->draco);
  if (wanted != nullptr) options.about = wanted->about;
  if (wanted != nullptr) options.topologies = wanted->topologies;
  const FileFormat& format = wanted != nullptr ? *wanted->format : all_formats().front();
  auto outcome = format.write(scene_of(model, context.cancel()), options, context.cancel());
  if (!outcome) {
    const FileError& error = outcome.error();
    return error.code == "nothing-to-export" && error.detail.empty() ? nothing_to_export(model)
                                                                     : Failure{error.code, error.detail, "model"};
  }
  WrittenFile& written = *outcome;
  warn_of_what_is_left_out(context, model);
  warn_of_coarse_circles(context, model);
  for (FileNote& note : written.notes) context.warn({std::move(note.code), std::move(note.detail), "model"});
  const Digest digest = sha256(written.bytes);
  return std::make_shared<const File>(File{format.media_types.front(), format.extension,
                                           share(std::move(written.bytes)), digest, written.vertices, written.triangles,
                                           written.position_error, written.attribute_errors});
}

}  // namespace

void add_export(Registry& registry) {
  registry.add(
      node("export", export_file)
          .title("Export")
          .family("answers")
          .synonyms({"save", "output", "download", "file", "glb", "gltf", "render", "write"})
          .doc("Writes meshes, circles and points as one file: glTF with Draco, or what is asked for.")
          .details("Everything shares one quantization grid, so seams never crack. Circles and points travel "
                   "uncompressed; of more than 15 625 circles each has fewer than the usual 256 segments. "
                   "Parts and materials have the ids of the nodes that made them. Graphs are Z up; the root node of a "
                   "glTF turns to Y up, other formats stay Z up. All are in meters; where the document says a unit, "
                   "STL, 3MF and SVG are in millimeters.")
          .input("model", "Meshes, circles or points, over any axes.", required().several())
          .input("position_bits", &ExportInputs::position_bits, "Bits per coordinate over the largest extent.",
                 defaults(14).hard(8, 20).unit("bit").title("Position precision"))
          .input("normal_bits", &ExportInputs::normal_bits, "Bits per normal coordinate.",
                 defaults(10).hard(6, 16).unit("bit").title("Normal precision"))
          .input("uv_bits", &ExportInputs::uv_bits, "Bits per texture coordinate over its range.",
                 defaults(12).hard(8, 20).unit("bit").title("Texture precision"))
          .input("speed", &ExportInputs::speed, "0 smallest file, 10 fastest.",
                 defaults(7).hard(0, 10).title("Quick or small"))
          .input("normals", &ExportInputs::normals, "Whether normals are sent.", defaults(true).title("With normals"))
          .input("draco", &ExportInputs::draco,
                 "Whether meshes are compressed with Draco; many programs read only files without.",
                 defaults(true).title("Compressed"))
          .depends_on_quality()
          .names_parts()
          .cost(cost_of_export)
          .output("asset", "The file."));
}

}  // namespace dini

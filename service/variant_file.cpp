#include "service/variant_file.h"

#include <algorithm>

#include "gltf/glb_assembly.h"
#include "service/version.h"

namespace dini {
namespace {

constexpr const char* media_type = "model/gltf-binary";
constexpr const char* extension = ".glb";

std::string name_of(const VariantModel& variant) {
  std::string name;
  for (const auto& [parameter, value] : variant.setting.items()) {
    name += (name.empty() ? "" : ", ") + parameter + "=" + (value.is_string() ? value.get<std::string>() : dump(value));
  }
  return name.empty() ? "variant " + std::to_string(variant.index) : name;
}

}  // namespace

Result<SharedFile> variant_file(const std::vector<VariantModel>& variants, const Graph& graph, const Json& fixed) {
  std::vector<GlbItem> items;
  File file{media_type, extension, nullptr};
  for (const VariantModel& variant : variants) {
    GlbItem item{.name = name_of(variant), .extras = {{"index", variant.index}, {"parameters", variant.setting}}};
    for (const auto& [output, model] : variant.models) {
      if (output.empty()) {
        item.glb = *model->bytes;
      } else {
        item.items.push_back({.name = output, .extras = nullptr, .glb = *model->bytes});
      }
      file.vertices += model->vertices;
      file.triangles += model->triangles;
      file.position_error = std::max(file.position_error, model->position_error);
    }
    items.push_back(std::move(item));
  }
  auto glb = assemble_glb(items, {{"engine", engine_version},
                                  {"graph_hash", to_hex(graph.hash)},
                                  {"parameters", fixed},
                                  {"variants", variants.size()}});
  if (!glb) {
    return Problem{.code = "limit-exceeded",
                   .detail = "the models of all variants are more than one GLB can hold; ask for lines instead",
                   .in_request = true};
  }
  file.sha256 = sha256(*glb);
  file.bytes = share(*std::move(glb));
  return std::make_shared<const File>(std::move(file));
}

}  // namespace dini

// Derivatives as colors of a model.

#include <algorithm>

#include "fitting/gradient.h"
#include "geometry/palette.h"
#include "gltf/glb_groups.h"
#include "graph/request_problem.h"
#include "graph/stopped.h"
#include "service/version.h"

namespace dini::fitting {
namespace {

double speed_at(const Derivative& derivative, std::size_t vertex) {
  const auto first = derivative.slopes.begin() + static_cast<std::ptrdiff_t>(3 * vertex);
  return length(Vector{first[0], first[1], first[2]});
}

/// The meshes of one output, whose vertices come one after the other in its derivative.
void add_meshes(const Differentiated& output, double fastest, GlbGroup& group) {
  const Derivative& derivative = output.by.front();
  const Column<SharedMesh>& meshes = column_of<SharedMesh>(output.value);
  GlbChild child{.name = output.place, .extras = nullptr, .parts = {}};
  std::size_t vertex = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    auto mesh = std::make_shared<Mesh>(*meshes[i]);
    NumberList<std::array<float, 4>> colors;
    for (std::size_t k = 0; k < mesh->positions.size(); ++k) {
      const double share = fastest > 0 ? speed_at(derivative, vertex++) / fastest : 0;
      colors.push_back(palette_color(Palette::sequential, share));
    }
    mesh->colors = std::move(colors);
    mesh->color = {1, 1, 1, 1};
    child.parts.push_back({.name = output.place, .shape = SharedMesh(std::move(mesh))});
  }
  group.children.push_back(std::move(child));
}

}  // namespace

Result<std::string> colored(const Gradient& gradient, const Cancel& cancel) {
  if (gradient.parameters.size() != 1) {
    return request_problem("/by", "limit-exceeded",
                           "colors show how a model moves with one parameter, and " +
                               std::to_string(gradient.parameters.size()) + " are asked for; name one in `by`");
  }
  double fastest = 0;
  bool has_mesh = false;
  for (const Differentiated& output : gradient.outputs) {
    if (output.value.type() != WireType::mesh) continue;
    has_mesh = true;
    const Derivative& derivative = output.by.front();
    for (std::size_t k = 0; 3 * k < derivative.slopes.size(); ++k) fastest = std::max(fastest, speed_at(derivative, k));
  }
  if (!has_mesh)
    return request_problem("/of", "type-mismatch", "none of these outputs is a mesh, which alone can be colored");
  // What is within the error is no motion.
  for (const Differentiated& output : gradient.outputs) {
    if (output.value.type() == WireType::mesh && fastest <= output.by.front().error) fastest = 0;
  }
  GlbGroup group{.name = gradient.parameters.front(), .extras = Json::object(), .children = {}};
  for (const Differentiated& output : gradient.outputs) {
    if (output.value.type() == WireType::mesh) add_meshes(output, fastest, group);
  }
  EncodeOptions options;
  options.extras = {{"engine", engine_version},
                    {"gradient",
                     {{"parameter", gradient.parameters.front()},
                      {"at", gradient.at.front()},
                      {"range", gradient.ranges.front()},
                      {"fastest", fastest}}}};
  EncodeResult<std::string> encoded = encode_groups({group}, options, cancel);
  if (encoded) return *std::move(encoded);
  if (encoded.error().code == EncodeError::Code::canceled) return stopped_problem(cancel.reason());
  return Problem{.code = "encode-failed", .detail = encoded.error().detail, .in_request = true};
}

}  // namespace dini::fitting

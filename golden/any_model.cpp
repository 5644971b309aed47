#include "golden/any_model.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "geometry/json.h"
#include "gltf/glb_container.h"
#include "gltf/glb_import.h"

namespace dini {
namespace {

/// As many as a model of this program can have.
constexpr ImportLimits limits{.vertices = 5'000'000, .triangles = 10'000'000};

struct Origin {
  bool is_ours = false;
  bool has_draco = false;
};

Origin origin_of(std::string_view glb) {
  const auto chunks = split_glb(glb);
  const Json document = chunks ? Json::parse(chunks->json, nullptr, false) : Json();
  if (!document.is_object()) return {};
  const auto asset = document.find("asset"), used = document.find("extensionsUsed");
  Origin origin;
  origin.is_ours =
      asset != document.end() && asset->is_object() && asset->contains("generator") && (*asset)["generator"] == "Dini";
  origin.has_draco = used != document.end() && used->is_array() &&
                     std::ranges::find(*used, Json("KHR_draco_mesh_compression")) != used->end();
  return origin;
}

/// glTF is Y up. The colors of materials are in those of vertices already.
Shape upright(const Mesh& mesh) {
  auto turned = std::make_shared<Mesh>(mesh);
  turned->color = {1, 1, 1, 1};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vector at = to_vector(mesh.positions[i]);
    turned->positions.set(i, to_point({at.x, -at.z, at.y}));
  }
  return shape_of({{.name = "", .shape = SharedMesh(std::move(turned))}});
}

/// Half a step of the floats that positions are.
double round_off(const Shape& shape) {
  double largest = 0;
  for (const Vector& at : shape.points) {
    largest = std::max({largest, std::abs(at.x), std::abs(at.y), std::abs(at.z)});
  }
  return std::ldexp(largest, -24);
}

}  // namespace

Expected<AnyModel, std::string> read_any_model(std::string_view glb) {
  const Origin origin = origin_of(glb);
  if (origin.is_ours && origin.has_draco) {
    std::optional<Model> model = model_of_bytes(glb);
    if (!model) return std::string("the file is damaged");
    return AnyModel{*std::move(model)};
  }
  ImportResult read = read_glb_mesh(glb, limits);
  if (!read && origin.has_draco) {
    return std::string(
        "its meshes are compressed by another program, and Draco is read of dini only; "
        "give it without compression");
  }
  if (!read) return read.error().detail;
  Shape shape = upright(read->mesh);
  const double error = round_off(shape);
  return AnyModel{model_of_shape(std::move(shape), glb, error), std::move(read->warnings)};
}

}  // namespace dini

#include "graph/value_json.h"

#include "algebra/extract.h"
#include "graph/digest.h"

namespace dini {

namespace {

Json triple(const Vector& v) { return {v.x, v.y, v.z}; }
Json triple(const Point& p) { return {p.x, p.y, p.z}; }

Json one(double number, bool) { return number; }
Json one(const Vector& vector, bool) { return triple(vector); }
Json one(const Point& point, bool) { return is_finite(point) ? triple(point) : Json(nullptr); }

Json one(const Generator& generator, bool) {
  return {{"no_e", triple(generator.no_e)},
          {"e_e", triple(generator.e_e)},
          {"no_ni", generator.no_ni},
          {"e_ni", triple(generator.e_ni)}};
}

Json one(const Circle& circle, bool) {
  const std::optional<CircleCoordinates> found = coordinates(circle);
  if (!found) return nullptr;
  if (found->line) return {{"line", true}, {"point", triple(found->point)}, {"direction", triple(found->direction)}};
  return {{"center", triple(found->center)}, {"radius", found->radius}, {"normal", triple(found->normal)}};
}

Json one(const Sphere& sphere, bool) {
  const std::optional<SphereCoordinates> found = coordinates(sphere);
  if (!found) return nullptr;
  if (found->plane) return {{"plane", true}, {"normal", triple(found->normal)}, {"distance", found->distance}};
  return {{"center", triple(found->center)}, {"radius", found->radius}};
}

Json one(const SharedMesh& mesh, bool full) {
  Vector least = {0, 0, 0}, most = {0, 0, 0};
  for (std::size_t i = 0; i < mesh->positions.size(); ++i) {
    const Point p = mesh->positions[i];
    least = i == 0 ? to_vector(p) : Vector{std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
    most = i == 0 ? to_vector(p) : Vector{std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
  }
  Json json = {{"vertices", mesh->positions.size()},
               {"triangles", mesh->triangles.size()},
               {"bounds", {triple(least), triple(most)}}};
  if (full) {
    Json positions = Json::array();
    for (std::size_t i = 0; i < mesh->positions.size(); ++i) positions.push_back(triple(mesh->positions[i]));
    json["positions"] = std::move(positions);
    json["indices"] = mesh->triangles;
  }
  return json;
}

Json one(const SharedAsset& asset, bool) {
  return {{"media_type", asset->media_type}, {"bytes", asset->bytes.size()}, {"sha256", to_hex(sha256(asset->bytes))}};
}

}  // namespace

Json to_json(const Axes& axes) {
  Json json = Json::array();
  for (const Axis& axis : axes) json.push_back({{"name", axis.name}, {"size", axis.size}, {"closed", axis.closed}});
  return json;
}

Json to_json(const Value& value, bool full) {
  Json values = Json::array();
  std::visit(
      [&](const auto& column) {
        for (std::size_t i = 0; i < column->size(); ++i) values.push_back(one((*column)[i], full));
      },
      value.column);
  return {{"type", name(value.type())}, {"axes", to_json(value.axes)}, {"values", std::move(values)}};
}

}  // namespace dini

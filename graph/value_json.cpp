#include "graph/value_json.h"

#include "algebra/extract.h"
#include "graph/digest.h"

namespace dini {

namespace {

Json triple(const Vector& v) { return {v.x, v.y, v.z}; }
Json triple(const Point& p) { return {p.x, p.y, p.z}; }

Json one(double number) { return number; }
Json one(const Vector& vector) { return triple(vector); }
Json one(const Point& point) { return is_finite(point) ? triple(point) : Json(nullptr); }

Json one(const Generator& generator) {
  return {{"no_e", triple(generator.no_e)},
          {"e_e", triple(generator.e_e)},
          {"no_ni", generator.no_ni},
          {"e_ni", triple(generator.e_ni)}};
}

Json one(const Circle& circle) {
  const std::optional<CircleCoordinates> found = coordinates(circle);
  if (!found) return nullptr;
  if (found->line) return {{"line", true}, {"point", triple(found->point)}, {"direction", triple(found->direction)}};
  return {{"center", triple(found->center)}, {"radius", found->radius}, {"normal", triple(found->normal)}};
}

Json one(const Sphere& sphere) {
  const std::optional<SphereCoordinates> found = coordinates(sphere);
  if (!found) return nullptr;
  if (found->plane) return {{"plane", true}, {"normal", triple(found->normal)}, {"distance", found->distance}};
  return {{"center", triple(found->center)}, {"radius", found->radius}};
}

Json one(const SharedFile& file) {
  return {{"media_type", file->media_type}, {"bytes", file->bytes->size()}, {"sha256", to_hex(file->sha256)}};
}

Json one(const SharedField& field) {
  constexpr std::size_t longest_formula = 400;
  std::string formula = field->formula();
  if (formula.size() > longest_formula) formula = formula.substr(0, longest_formula) + "...";
  Json json = {{"formula", formula},
               {"operations", field->size().operations},
               {"depth", field->size().depth},
               {"surface_within", nullptr}};
  if (const std::optional<Reach>& reach = field->reach()) {
    json["surface_within"] = {{"center", triple(reach->ball.center)}, {"radius", reach->ball.radius}};
  }
  return json;
}

Json bounds_of(const Column<Point>& points, CancelEvery& steps) {
  Vector least = {0, 0, 0}, most = {0, 0, 0};
  for (std::size_t i = 0; i < points.size() && !steps.stopped(); ++i) {
    const Point p = points[i];
    least = i == 0 ? to_vector(p) : Vector{std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
    most = i == 0 ? to_vector(p) : Vector{std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
  }
  return {triple(least), triple(most)};
}

/// Writes values as text, one after another, so that they never exist as a document in memory.
class TextWriter {
 public:
  TextWriter(bool full, const Cancel& cancel) : full_(full), steps_(cancel) {}

  template <class T>
  void write(const Column<T>& column) {
    for (std::size_t i = 0; i < column.size() && !steps_.stopped(); ++i) {
      if (i > 0) text_ += ',';
      if constexpr (std::is_same_v<T, SharedMesh>) {
        write(*column[i]);
      } else {
        text_ += one(column[i]).dump();
      }
    }
  }

  std::string& text() { return text_; }

 private:
  void write(const Mesh& mesh) {
    text_ += "{\"bounds\":" + bounds_of(mesh.positions, steps_).dump();
    if (full_) {
      text_ += ",\"indices\":[";
      for (std::size_t i = 0; i < mesh.triangles.size() && !steps_.stopped(); ++i) {
        text_ += (i > 0 ? "," : "") + Json(mesh.triangles[i]).dump();
      }
      text_ += "],\"positions\":[";
      write(*mesh.positions);
      text_ += ']';
    }
    text_ += ",\"triangles\":" + std::to_string(mesh.triangles.size()) +
             ",\"vertices\":" + std::to_string(mesh.positions.size()) + "}";
  }

  bool full_;
  CancelEvery steps_;
  std::string text_;
};

}  // namespace

Json to_json(const Axes& axes) {
  Json json = Json::array();
  for (const Axis& axis : axes) json.push_back({{"name", axis.name}, {"size", axis.size}, {"closed", axis.closed}});
  return json;
}

std::string to_json_text(const Value& value, bool full, const Cancel& cancel) {
  TextWriter values(full, cancel);
  std::visit([&](const auto& column) { values.write(*column); }, value.column);
  std::string text =
      "{\"axes\":" + to_json(value.axes).dump() + ",\"type\":" + Json(name(value.type())).dump() + ",\"values\":[";
  text += values.text();
  text += "]}";
  return text;
}

Json to_json(const Value& value, bool full) { return Json::parse(to_json_text(value, full, Cancel())); }

}  // namespace dini

#include "gltf/glb_reader.h"

#include <cstring>
#include <draco/compression/decode.h>
#include <draco/core/decoder_buffer.h>
#include <draco/mesh/mesh.h>
#include <exception>
#include <stdexcept>
#include <utility>

#include "geometry/json.h"
#include "gltf/glb_container.h"
#include "gltf/lines.h"

namespace dini {
namespace {

constexpr int points_mode = 0;
constexpr int lines_mode = 1;
constexpr const char* draco_extension = "KHR_draco_mesh_compression";

// One row per decoded vertex.
template <class Value, std::size_t width>
std::vector<std::array<Value, width>> attribute_rows(const draco::Mesh& mesh, const Json& ids, const char* name) {
  std::vector<std::array<Value, width>> rows;
  if (!ids.contains(name)) return rows;
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(ids.at(name).get<std::uint32_t>());
  if (attribute == nullptr) throw std::runtime_error("missing attribute");
  if (attribute->byte_stride() != static_cast<std::int64_t>(sizeof(rows[0])))
    throw std::runtime_error("other attribute");
  rows.resize(mesh.num_points());
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
    attribute->GetMappedValue(draco::PointIndex(i), rows[i].data());
  }
  return rows;
}

template <class Element>
void append_column(Column<Element>& column, const std::vector<std::array<float, 3>>& rows) {
  Column<Element> longer(column.size() + rows.size());
  for (std::size_t i = 0; i < column.size(); ++i) longer.set(i, column[i]);
  for (std::size_t i = 0; i < rows.size(); ++i) longer.set(column.size() + i, {rows[i][0], rows[i][1], rows[i][2]});
  column = std::move(longer);
}

class Reader {
 public:
  explicit Reader(const GlbChunks& chunks) : document_(Json::parse(chunks.json)), binary_(chunks.binary) {}

  Scene read() const {
    Scene scene;
    for (const Json& node : document_.at("nodes")) {
      if (node.contains("mesh"))
        scene.parts.push_back(read_part(document_.at("meshes").at(node.at("mesh").get<std::size_t>())));
    }
    return scene;
  }

 private:
  Part read_part(const Json& mesh) const {
    Part part;
    part.name = mesh.value("name", "");
    const Json& primitives = mesh.at("primitives");
    const Json& first = primitives.at(0);
    const Json& material = document_.at("materials").at(first.at("material").get<std::size_t>());
    part.color = material.at("pbrMetallicRoughness").value("baseColorFactor", Color{1, 1, 1, 1});
    if (first.contains("extensions")) {
      auto decoded = std::make_shared<Mesh>();
      decoded->color = part.color;
      for (const Json& primitive : primitives) append_tile(primitive.at("extensions").at(draco_extension), *decoded);
      part.shape = std::move(decoded);
    } else if (first.at("mode") == points_mode) {
      Column<Point> points;
      append_column(points, floats(first));
      part.shape = std::make_shared<const Column<Point>>(std::move(points));
    } else {
      part.shape = read_polylines(primitives);
    }
    return part;
  }

  void append_tile(const Json& extension, Mesh& mesh) const {
    const std::string_view bytes = view(extension.at("bufferView"));
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data(), bytes.size());
    auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) throw std::runtime_error(decoded.status().error_msg_string());
    const draco::Mesh& tile = *decoded.value();
    const Json& ids = extension.at("attributes");
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    append_column(mesh.positions.edit(), attribute_rows<float, 3>(tile, ids, "POSITION"));
    append_column(mesh.normals.edit(), attribute_rows<float, 3>(tile, ids, "NORMAL"));
    for (const auto& [u, v] : attribute_rows<float, 2>(tile, ids, "TEXCOORD_0")) mesh.uvs.push_back({u, v});
    for (const auto& color : attribute_rows<std::uint16_t, 4>(tile, ids, "COLOR_0")) {
      auto& target = mesh.colors.emplace_back();
      for (std::size_t i = 0; i < 4; ++i) target[i] = static_cast<float>(color[i]) / 65535.0f;
    }
    for (std::uint32_t i = 0; i < tile.num_faces(); ++i) {
      const auto& face = tile.face(draco::FaceIndex(i));
      for (const draco::PointIndex& corner : face) {
        if (corner.value() >= tile.num_points()) throw std::runtime_error("corner without a point");
      }
      mesh.triangles.push_back({base + face[0].value(), base + face[1].value(), base + face[2].value()});
    }
    mesh.tile_ends.push_back(mesh.triangles.size());
  }

  std::vector<Polyline> read_polylines(const Json& primitives) const {
    std::vector<Polyline> polylines;
    for (const Json& primitive : primitives) {
      const FloatPoints points = floats(primitive);
      if (primitive.at("mode") != lines_mode) {
        polylines.push_back(to_polyline(points));
        continue;
      }
      const Json& accessor = document_.at("accessors").at(primitive.at("indices").get<std::size_t>());
      const std::string_view bytes = view(accessor.at("bufferView"));
      const auto count = accessor.at("count").get<std::size_t>();
      if (count % 2 != 0 || bytes.size() / sizeof(std::uint32_t) < count) throw std::runtime_error("short buffer view");
      std::vector<std::uint32_t> segments(count);
      std::memcpy(segments.data(), bytes.data(), segments.size() * sizeof(segments[0]));
      FloatPoints run;
      for (std::size_t i = 0; i < segments.size(); i += 2) {
        if (run.empty()) run.push_back(points.at(segments[i]));
        run.push_back(points.at(segments[i + 1]));
        if (i + 2 < segments.size() && segments[i + 2] == segments[i + 1]) continue;
        polylines.push_back(to_polyline(run));
        run.clear();
      }
    }
    return polylines;
  }

  static Polyline to_polyline(FloatPoints points) {
    Polyline polyline;
    polyline.closed = points.size() > 2 && points.front() == points.back();
    if (polyline.closed) points.pop_back();
    append_column(polyline.points, points);
    return polyline;
  }

  // The plain positions of a primitive.
  FloatPoints floats(const Json& primitive) const {
    const auto index = primitive.at("attributes").at("POSITION").get<std::size_t>();
    const Json& accessor = document_.at("accessors").at(index);
    const std::string_view bytes = view(accessor.at("bufferView")).substr(accessor.value("byteOffset", std::size_t{0}));
    const auto count = accessor.at("count").get<std::size_t>();
    if (bytes.size() / sizeof(FloatPoints::value_type) < count) throw std::runtime_error("short buffer view");
    FloatPoints points(count);
    std::memcpy(points.data(), bytes.data(), points.size() * sizeof(points[0]));
    return points;
  }

  std::string_view view(const Json& index) const {
    const Json& description = document_.at("bufferViews").at(index.get<std::size_t>());
    return binary_.substr(description.value("byteOffset", std::size_t{0}),
                          description.at("byteLength").get<std::size_t>());
  }

  Json document_;
  std::string_view binary_;
};

}  // namespace

std::optional<Scene> read_glb(std::string_view glb) {
  const auto chunks = split_glb(glb);
  if (!chunks) return std::nullopt;
  try {
    return Reader(*chunks).read();
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace dini

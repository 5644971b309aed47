#include "gltf/glb_model.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <utility>

namespace dini {
namespace {

constexpr const char* draco_extension = "KHR_draco_mesh_compression";
constexpr std::size_t most_strips = 64;

// glTF demands [0, 1]; a NaN becomes 0.
double unit_interval(double value) { return value > 0 ? std::min(value, 1.0) : 0.0; }

std::vector<double> to_doubles(const std::array<float, 3>& values) { return {values.begin(), values.end()}; }

FloatBox box_of(const FloatPoints& points) {
  FloatBox box;
  for (const auto& point : points) box.include(point);
  return box;
}

tinygltf::Accessor accessor_of(int component_type, int type, std::size_t count) {
  tinygltf::Accessor accessor;
  accessor.componentType = component_type;
  accessor.type = type;
  accessor.count = count;
  return accessor;
}

}  // namespace

GlbModel::GlbModel(const std::string& generator) {
  model_.asset.version = "2.0";
  model_.asset.generator = generator;
  model_.buffers.emplace_back();
  tinygltf::Node root;
  root.name = "Z up to Y up";
  const double half_turn = std::sqrt(0.5);
  root.rotation = {-half_turn, 0, 0, half_turn};
  model_.nodes.push_back(root);
  tinygltf::Scene scene;
  scene.nodes = {0};
  model_.scenes.push_back(scene);
  model_.defaultScene = 0;
}

void GlbModel::begin_part(const std::string& name) {
  tinygltf::Mesh mesh;
  mesh.name = name;
  tinygltf::Node node;
  node.name = name;
  node.mesh = static_cast<int>(model_.meshes.size());
  model_.nodes[0].children.push_back(static_cast<int>(model_.nodes.size()));
  model_.meshes.push_back(mesh);
  model_.nodes.push_back(node);
}

void GlbModel::add_tile(const EncodedTile& tile, const FloatBox& bounds, const Color& color, bool translucent) {
  if (model_.extensionsUsed.empty()) {
    model_.extensionsUsed = {draco_extension};
    model_.extensionsRequired = {draco_extension};
  }
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  tinygltf::Value::Object draco_ids;
  const auto add_attribute = [&](const char* name, int draco_id, tinygltf::Accessor accessor) {
    if (draco_id < 0) return;
    primitive.attributes[name] = add_accessor(std::move(accessor));
    draco_ids[name] = tinygltf::Value(draco_id);
  };
  // Accessors without a buffer view describe the decompressed data.
  auto positions = accessor_of(TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, tile.vertices);
  positions.minValues = to_doubles(bounds.minimum);
  positions.maxValues = to_doubles(bounds.maximum);
  add_attribute("POSITION", tile.position_id, positions);
  add_attribute("NORMAL", tile.normal_id,
                accessor_of(TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, tile.vertices));
  add_attribute("TEXCOORD_0", tile.uv_id,
                accessor_of(TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2, tile.vertices));
  auto colors = accessor_of(TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_VEC4, tile.vertices);
  colors.normalized = true;
  add_attribute("COLOR_0", tile.color_id, colors);
  primitive.indices =
      add_accessor(accessor_of(TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, 3 * tile.triangles));
  tinygltf::Value::Object extension;
  extension["bufferView"] = tinygltf::Value(add_bytes(tile.bytes.data(), tile.bytes.size(), 0));
  extension["attributes"] = tinygltf::Value(draco_ids);
  primitive.extensions[draco_extension] = tinygltf::Value(extension);
  primitive.material = add_material(tile.color_id < 0 ? color : Color{1, 1, 1, 1}, translucent);
  primitives().push_back(std::move(primitive));
}

void GlbModel::add_runs(const std::vector<FloatPoints>& runs, const Color& color) {
  FloatPoints points;
  for (const FloatPoints& run : runs) points.insert(points.end(), run.begin(), run.end());
  const int view = add_bytes(points.data(), points.size() * sizeof(points[0]), TINYGLTF_TARGET_ARRAY_BUFFER);
  model_.bufferViews.back().byteStride = sizeof(points[0]);
  const int material = add_material(color, false);
  std::size_t first = 0;
  if (runs.size() <= most_strips) {
    for (const FloatPoints& run : runs) {
      const int positions = add_positions(view, first * sizeof(points[0]), run.size(), box_of(run));
      add_primitive(TINYGLTF_MODE_LINE_STRIP, positions, -1, material);
      first += run.size();
    }
    return;
  }
  std::vector<std::uint32_t> segments;
  for (const FloatPoints& run : runs) {
    for (std::size_t i = 1; i < run.size(); ++i) {
      segments.push_back(static_cast<std::uint32_t>(first + i - 1));
      segments.push_back(static_cast<std::uint32_t>(first + i));
    }
    first += run.size();
  }
  auto indices = accessor_of(TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, segments.size());
  indices.bufferView =
      add_bytes(segments.data(), segments.size() * sizeof(segments[0]), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  const int positions = add_positions(view, 0, points.size(), box_of(points));
  add_primitive(TINYGLTF_MODE_LINE, positions, add_accessor(indices), material);
}

void GlbModel::add_points(const FloatPoints& points, const Color& color) {
  const int view = add_bytes(points.data(), points.size() * sizeof(points[0]), TINYGLTF_TARGET_ARRAY_BUFFER);
  const int positions = add_positions(view, 0, points.size(), box_of(points));
  add_primitive(TINYGLTF_MODE_POINTS, positions, -1, add_material(color, false));
}

std::string GlbModel::write() {
  std::ostringstream stream(std::ios::binary);
  tinygltf::TinyGLTF writer;
  if (!writer.WriteGltfSceneToStream(&model_, stream, false, true)) return {};
  return std::move(stream).str();
}

int GlbModel::add_bytes(const void* data, std::size_t size, int target) {
  auto& binary = model_.buffers[0].data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = binary.size();
  view.byteLength = size;
  view.target = target;
  const std::size_t padded = (size + 3) / 4 * 4;
  binary.resize(binary.size() + padded);
  std::memcpy(binary.data() + view.byteOffset, data, size);
  model_.bufferViews.push_back(view);
  return static_cast<int>(model_.bufferViews.size()) - 1;
}

int GlbModel::add_accessor(tinygltf::Accessor accessor) {
  model_.accessors.push_back(std::move(accessor));
  return static_cast<int>(model_.accessors.size()) - 1;
}

int GlbModel::add_positions(int view, std::size_t offset, std::size_t count, const FloatBox& box) {
  auto accessor = accessor_of(TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, count);
  accessor.bufferView = view;
  accessor.byteOffset = offset;
  accessor.minValues = to_doubles(box.minimum);
  accessor.maxValues = to_doubles(box.maximum);
  return add_accessor(std::move(accessor));
}

int GlbModel::add_material(const Color& color, bool translucent) {
  Color factor;
  std::transform(color.begin(), color.end(), factor.begin(), unit_interval);
  const bool blended = translucent || factor[3] < 1;
  const auto [entry, is_new] = materials_.try_emplace({factor, blended}, static_cast<int>(model_.materials.size()));
  if (is_new) {
    tinygltf::Material material;
    material.pbrMetallicRoughness.baseColorFactor = {factor.begin(), factor.end()};
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 0.6;
    material.doubleSided = true;
    if (blended) material.alphaMode = "BLEND";
    model_.materials.push_back(std::move(material));
  }
  return entry->second;
}

void GlbModel::add_primitive(int mode, int positions, int indices, int material) {
  tinygltf::Primitive primitive;
  primitive.mode = mode;
  primitive.attributes["POSITION"] = positions;
  primitive.indices = indices;
  primitive.material = material;
  primitives().push_back(std::move(primitive));
}

}  // namespace dini

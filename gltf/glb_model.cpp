#include "gltf/glb_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "geometry/length_unit.h"
#include "gltf/base64.h"
#include "gltf/glb_container.h"

namespace dini {
namespace {

constexpr const char* draco_extension = "KHR_draco_mesh_compression";
constexpr std::size_t most_strips = 64;
constexpr int unsigned_short = 5123, unsigned_int = 5125, real = 5126;
constexpr int array_buffer = 34962, element_array_buffer = 34963;
constexpr int points_mode = 0, lines_mode = 1, line_strip_mode = 3, triangles_mode = 4;

// glTF demands [0, 1]; a NaN becomes 0.
double unit_interval(double value) { return value > 0 ? std::min(value, 1.0) : 0.0; }

Json accessor_of(int component_type, const char* type, std::size_t count) {
  return {{"componentType", component_type}, {"count", count}, {"type", type}};
}

void set_bounds(Json& accessor, const FloatBox& box) {
  accessor["min"] = box.minimum;
  accessor["max"] = box.maximum;
}

FloatBox box_of(std::span<const std::array<float, 3>> points, const Cancel& cancel) {
  FloatBox box;
  CancelEvery steps(cancel);
  for (const auto& point : points) {
    if (steps.stopped()) break;
    box.include(point);
  }
  return box;
}

/// The look of a mesh whose vertices have colors of their own, which a material multiplies.
GlbModel::Look under_colors(GlbModel::Look look) {
  look.color = {1, 1, 1, 1};
  return look;
}

std::string list_of(const char* name, const std::string& objects) {
  return objects.empty() ? "" : ",\"" + std::string(name) + "\":[" + objects + "]";
}

}  // namespace

std::size_t GlbModel::ObjectList::add(const std::string& object) {
  if (count > 0) text += ',';
  text += object;
  return count++;
}

GlbModel::GlbModel(const std::string& generator, const Json& extras)
    : asset_({{"generator", generator}, {"version", "2.0"}}) {
  if (!extras.is_null()) asset_["extras"] = extras;
}

void GlbModel::begin_group(const std::string& name, Json extras) {
  finish_mesh();
  group_ = Group{nodes_.size(), {{"name", name}, {"extras", std::move(extras)}}, {}};
  nodes_.emplace_back();
  below_root_.push_back(nodes_.size());
}

void GlbModel::end_group() {
  finish_mesh();
  if (group_->children.empty()) {
    group_->object["extras"]["drawable"] = false;
  } else {
    group_->object["children"] = group_->children;
  }
  nodes_[group_->node] = group_->object.dump();
  group_.reset();
}

void GlbModel::begin_part(PartNames names) {
  finish_mesh();
  part_ = std::move(names);
}

void GlbModel::finish_mesh() {
  if (primitives_.empty()) return;
  Json node = {{"mesh", meshes_.count}, {"name", part_.node}};
  if (!part_.extras.is_null()) node["extras"] = std::move(part_.extras);
  meshes_.add("{\"name\":" + Json(part_.mesh).dump() + ",\"primitives\":[" + std::exchange(primitives_, {}) + "]}");
  nodes_.push_back(node.dump());
  (group_ ? group_->children : below_root_).push_back(nodes_.size());
}

void GlbModel::add_tile(const EncodedTile& tile, const FloatBox& bounds, const Look& look) {
  compressed_ = true;
  Json attributes = Json::object(), ids = Json::object();
  // Accessors without a buffer view describe the decompressed data.
  const auto add_attribute = [&](const char* name, int id, const Json& accessor) {
    if (id < 0) return;
    attributes[name] = accessors_.add(accessor.dump());
    ids[name] = id;
  };
  Json positions = accessor_of(real, "VEC3", tile.vertices);
  set_bounds(positions, bounds);
  add_attribute("POSITION", tile.position_id, positions);
  add_attribute("NORMAL", tile.normal_id, accessor_of(real, "VEC3", tile.vertices));
  add_attribute("TEXCOORD_0", tile.uv_id, accessor_of(real, "VEC2", tile.vertices));
  Json colors = accessor_of(unsigned_short, "VEC4", tile.vertices);
  colors["normalized"] = true;
  add_attribute("COLOR_0", tile.color_id, colors);
  const std::size_t indices = accessors_.add(accessor_of(unsigned_int, "SCALAR", 3 * tile.triangles).dump());
  const std::size_t view = add_bytes(tile.bytes.data(), tile.bytes.size(), 0);
  add_primitive({{"mode", triangles_mode},
                 {"attributes", attributes},
                 {"indices", indices},
                 {"material", add_material(tile.color_id < 0 ? look : under_colors(look))},
                 {"extensions", {{draco_extension, {{"bufferView", view}, {"attributes", ids}}}}}});
}

/// Rows of an attribute or of indices in a view of their own; the accessor that describes them.
template <class Rows>
std::size_t GlbModel::add_rows(const Rows& rows, Json accessor, int target) {
  accessor["bufferView"] = add_bytes(rows.data(), rows.size() * sizeof(rows[0]), target);
  return accessors_.add(accessor.dump());
}

void GlbModel::add_plain_tile(const Tile& tile, const Look& look) {
  const std::size_t count = tile.positions.size();
  Json positions = accessor_of(real, "VEC3", count);
  set_bounds(positions, tile.position_box);
  Json attributes = {{"POSITION", add_rows(tile.positions, std::move(positions), array_buffer)}};
  if (!tile.normals.empty()) {
    attributes["NORMAL"] = add_rows(tile.normals, accessor_of(real, "VEC3", count), array_buffer);
  }
  if (!tile.uvs.empty()) {
    attributes["TEXCOORD_0"] = add_rows(tile.uvs, accessor_of(real, "VEC2", count), array_buffer);
  }
  if (!tile.colors.empty()) {
    Json colors = accessor_of(unsigned_short, "VEC4", count);
    colors["normalized"] = true;
    attributes["COLOR_0"] = add_rows(tile.colors, std::move(colors), array_buffer);
  }
  add_primitive({{"mode", triangles_mode},
                 {"attributes", attributes},
                 {"indices", add_indices(tile)},
                 {"material", add_material(tile.colors.empty() ? look : under_colors(look))}});
}

std::size_t GlbModel::add_indices(const Tile& tile) {
  const std::size_t count = 3 * tile.triangles.size();
  // The largest number of each kind means "begin anew" to some programs.
  if (tile.positions.size() > std::numeric_limits<std::uint16_t>::max()) {
    return add_rows(tile.triangles, accessor_of(unsigned_int, "SCALAR", count), element_array_buffer);
  }
  std::vector<std::uint16_t> indices;
  indices.reserve(count);
  for (const auto& triangle : tile.triangles) {
    for (const std::uint32_t vertex : triangle) indices.push_back(static_cast<std::uint16_t>(vertex));
  }
  return add_rows(indices, accessor_of(unsigned_short, "SCALAR", count), element_array_buffer);
}

FloatBox GlbModel::add_runs(const FloatRuns& runs, const Color& color, const Cancel& cancel) {
  const FloatPoints& points = runs.points;
  constexpr std::size_t stride = sizeof(points[0]);
  const std::size_t view = add_bytes(points.data(), points.size() * stride, array_buffer, stride);
  const std::size_t material = add_material({color});
  if (runs.ends.size() <= most_strips) {
    FloatBox all;
    std::size_t first = 0;
    for (const std::size_t end : runs.ends) {
      const FloatBox box = box_of(std::span(points).subspan(first, end - first), cancel);
      all.include(box);
      const std::size_t positions = add_positions(view, first * stride, end - first, box);
      add_primitive({{"mode", line_strip_mode}, {"attributes", {{"POSITION", positions}}}, {"material", material}});
      first = end;
    }
    return all;
  }
  std::vector<std::uint32_t> segments;
  segments.reserve(2 * (points.size() - runs.ends.size()));
  CancelEvery steps(cancel);
  std::size_t first = 0;
  for (const std::size_t end : runs.ends) {
    for (std::size_t i = first + 1; i < end && !steps.stopped(); ++i) {
      segments.push_back(static_cast<std::uint32_t>(i - 1));
      segments.push_back(static_cast<std::uint32_t>(i));
    }
    first = end;
  }
  Json indices = accessor_of(unsigned_int, "SCALAR", segments.size());
  indices["bufferView"] = add_bytes(segments.data(), segments.size() * sizeof(segments[0]), element_array_buffer);
  const FloatBox box = box_of(points, cancel);
  const std::size_t positions = add_positions(view, 0, points.size(), box);
  add_primitive({{"mode", lines_mode},
                 {"attributes", {{"POSITION", positions}}},
                 {"indices", accessors_.add(indices.dump())},
                 {"material", material}});
  return box;
}

FloatBox GlbModel::add_points(const FloatPoints& points, const Color& color, const Cancel& cancel) {
  constexpr std::size_t stride = sizeof(points[0]);
  const std::size_t view = add_bytes(points.data(), points.size() * stride, array_buffer);
  const FloatBox box = box_of(points, cancel);
  const std::size_t positions = add_positions(view, 0, points.size(), box);
  add_primitive(
      {{"mode", points_mode}, {"attributes", {{"POSITION", positions}}}, {"material", add_material({color})}});
  return box;
}

std::string GlbModel::write(GltfContainer container) {
  finish_mesh();
  const double half_turn = std::sqrt(0.5);
  Json root = {{"name", "Z up to Y up"}, {"rotation", {-half_turn, 0, 0, half_turn}}};
  // Where the scene counts in another unit than meters, the file says so about itself.
  const double meters = meters_of(unit_of(asset_.value("extras", Json())).value_or(LengthUnit::meter));
  if (meters != 1) root["scale"] = {meters, meters, meters};
  if (!below_root_.empty()) root["children"] = below_root_;
  // What a file says about itself comes first, where people look.
  std::string json = "{\"asset\":" + asset_.dump(-1, ' ', false, Json::error_handler_t::replace) +
                     list_of("accessors", accessors_.text) + list_of("bufferViews", views_.text);
  if (!binary_.empty()) json += list_of("buffers", buffer_object(container));
  if (compressed_) {
    const std::string extension = Json(draco_extension).dump();
    json += list_of("extensionsRequired", extension) + list_of("extensionsUsed", extension);
  }
  json += list_of("materials", materials_.text) + list_of("meshes", meshes_.text) + ",\"nodes\":[" + root.dump();
  for (const std::string& node : nodes_) json += "," + node;
  json += R"(],"scene":0,"scenes":[{"nodes":[0]}]})";
  return container == GltfContainer::binary ? join_glb(json, binary_) : json;
}

std::string GlbModel::buffer_object(GltfContainer container) const {
  const std::string size = std::to_string(binary_.size());
  if (container == GltfContainer::binary) return "{\"byteLength\":" + size + "}";
  return "{\"byteLength\":" + size + R"(,"uri":"data:application/octet-stream;base64,)" + to_base64(binary_) + "\"}";
}

std::size_t GlbModel::add_bytes(const void* data, std::size_t size, int target, std::size_t stride) {
  Json view = {{"buffer", 0}, {"byteLength", size}};
  if (!binary_.empty()) view["byteOffset"] = binary_.size();
  if (stride > 0) view["byteStride"] = stride;
  if (target > 0) view["target"] = target;
  binary_.append(static_cast<const char*>(data), size);
  binary_.resize((binary_.size() + 3) / 4 * 4);
  return views_.add(view.dump());
}

std::size_t GlbModel::add_positions(std::size_t view, std::size_t offset, std::size_t count, const FloatBox& box) {
  Json accessor = accessor_of(real, "VEC3", count);
  accessor["bufferView"] = view;
  if (offset > 0) accessor["byteOffset"] = offset;
  set_bounds(accessor, box);
  return accessors_.add(accessor.dump());
}

std::size_t GlbModel::add_material(Look look) {
  std::transform(look.color.begin(), look.color.end(), look.color.begin(), unit_interval);
  look.translucent = look.translucent || look.color[3] < 1;
  const auto [entry, is_new] = material_of_.try_emplace({part_.material, look}, materials_.count);
  if (is_new) {
    const Finish& finish = look.finish;
    Json surface = {{"metallicFactor", unit_interval(finish.metallic)},
                    {"roughnessFactor", unit_interval(finish.roughness)}};
    if (look.color != Color{1, 1, 1, 1}) surface["baseColorFactor"] = look.color;
    Json material = {{"doubleSided", finish.double_sided}, {"pbrMetallicRoughness", surface}};
    if (!part_.material.empty()) material["name"] = free_material_name();
    if (look.translucent) material["alphaMode"] = "BLEND";
    materials_.add(material.dump());
  }
  return entry->second;
}

/// The first look of a name has it; each other one is called like the part where it shows first.
std::string GlbModel::free_material_name() {
  if (material_names_.insert(part_.material).second) return part_.material;
  material_names_.insert(part_.mesh);
  return part_.mesh;
}

void GlbModel::add_primitive(const Json& primitive) {
  if (!primitives_.empty()) primitives_ += ',';
  primitives_ += primitive.dump();
}

}  // namespace dini

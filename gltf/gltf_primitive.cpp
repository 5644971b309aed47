#include "gltf/gltf_primitive.h"

#include "gltf/gltf_extensions.h"

namespace dini {

namespace {

const GltfJson& attributes_of(const GltfJson& primitive) {
  const GltfJson* attributes = object_member(primitive, "attributes");
  if (attributes == nullptr) refuse_gltf("it has no attributes");
  return *attributes;
}

/// An accessor of a primitive; null when it has none of that name. Compressed ones may have plain values beside them.
const GltfAccessor* accessor_of(GltfDocument& document, const GltfJson& primitive, const GltfJson& object,
                                const char* name) {
  const auto index = whole_number(object, name);
  if (!index) return nullptr;
  const GltfAccessor& accessor = document.accessor(*index);
  if (!accessor.is_stored() && extension_of(primitive, draco_extension) != nullptr) refuse_draco();
  return &accessor;
}

void check_attribute(const GltfAccessor* accessor, const char* name, bool right_width, std::size_t count) {
  if (accessor == nullptr) return;
  if (!right_width) refuse_gltf(std::string(name) + " has the wrong type");
  if (accessor->count() != count) refuse_gltf(std::string(name) + " is not one per position");
}

}  // namespace

std::optional<GltfMode> GltfPrimitive::mode_of(const GltfJson& primitive) {
  const std::size_t mode = whole_number(primitive, "mode").value_or(4);
  if (mode > 6) refuse_gltf("it has an unknown mode");
  return mode < 4 ? std::nullopt : std::optional(static_cast<GltfMode>(mode));
}

GltfPrimitive::GltfPrimitive(GltfDocument& document, const GltfJson& primitive, GltfMode the_mode)
    : mode(the_mode), material(GltfMaterial::of(document, primitive)) {
  const GltfJson& attributes = attributes_of(primitive);
  const auto attribute = [&](const char* name) { return accessor_of(document, primitive, attributes, name); };
  positions = attribute("POSITION");
  if (positions == nullptr) refuse_gltf("it has no positions");
  normals = attribute("NORMAL");
  uvs = attribute("TEXCOORD_0");
  colors = attribute("COLOR_0");
  const std::size_t count = positions->count();
  check_attribute(positions, "POSITION", positions->width() == 3, count);
  check_attribute(normals, "NORMAL", normals != nullptr && normals->width() == 3, count);
  check_attribute(uvs, "TEXCOORD_0", uvs != nullptr && uvs->width() == 2, count);
  check_attribute(colors, "COLOR_0", colors != nullptr && (colors->width() == 3 || colors->width() == 4), count);
  weights = GltfWeights(document, attributes, count);
  indices = accessor_of(document, primitive, primitive, "indices");
  if (indices != nullptr && !indices->is_index()) refuse_gltf("its indices are no unsigned whole numbers");
}

GltfTriangles::GltfTriangles(GltfDocument& document, const GltfPrimitive& primitive, std::size_t most) {
  const GltfAccessor& positions = *primitive.positions;
  const std::size_t corners = primitive.indices != nullptr ? primitive.indices->count() : positions.count();
  const bool apart = primitive.mode == GltfMode::triangles;
  if (apart && corners % 3 != 0) refuse_gltf("its corners do not come in threes");
  document.spend(corners);
  const auto vertex_at = [&](std::size_t corner) {
    const std::size_t vertex = primitive.indices != nullptr ? primitive.indices->whole(corner) : corner;
    if (vertex < positions.count()) return static_cast<std::uint32_t>(vertex);
    refuse_gltf("an index is " + std::to_string(vertex) + ", but there are " + std::to_string(positions.count()) +
                " vertices");
  };
  const std::size_t count = apart ? corners / 3 : corners - std::min<std::size_t>(corners, 2);
  for (std::size_t i = 0; i < count; ++i) {
    document.step();
    std::array<std::size_t, 3> at = {3 * i, 3 * i + 1, 3 * i + 2};
    if (primitive.mode == GltfMode::strip) at = {i, i + 1 + i % 2, i + 2 - i % 2};  // it turns over with each triangle
    if (primitive.mode == GltfMode::fan) at = {0, i + 1, i + 2};
    const std::array<std::uint32_t, 3> triangle = {vertex_at(at[0]), vertex_at(at[1]), vertex_at(at[2])};
    const auto [a, b, c] = triangle;
    const auto zero = [&](std::uint32_t vertex) { return positions.is_stored(vertex) ? 0 : 1; };
    if (a == b || b == c || c == a) {
      repeated += apart ? 1 : 0;
    } else if (!positions.is_stored() && zero(a) + zero(b) + zero(c) >= 2) {
      ++without_area;
    } else if (list.size() == most) {
      throw GltfRefused{too_many(most, "triangles")};
    } else {
      list.push_back(triangle);
    }
  }
}

}  // namespace dini

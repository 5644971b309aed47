#include "gltf/glb_import.h"

#include <algorithm>

#include "geometry/raw_mesh.h"
#include "gltf/affine.h"
#include "gltf/gltf_document.h"

namespace dini {

namespace {

/// Meshes can be used by many nodes, so a small file could ask for endless looking around.
constexpr std::size_t most_primitives = 100'000;

constexpr const char* draco = "KHR_draco_mesh_compression";

[[noreturn]] void refuse_draco() {
  refuse_gltf(std::string("it is compressed with ") + draco +
              ", which is not unpacked here; export it without compression");
}

/// The map of a node's own transform: a matrix by columns, or scale, then turn, then shift.
Affine transform_of(const GltfJson& node) {
  if (const auto m = number_list<16>(node, "matrix")) {
    const auto column = [&](std::size_t k) { return Vector{(*m)[4 * k], (*m)[4 * k + 1], (*m)[4 * k + 2]}; };
    return {{column(0), column(1), column(2)}, column(3)};
  }
  const auto scale = number_list<3>(node, "scale").value_or(std::array<double, 3>{1, 1, 1});
  const auto shift = number_list<3>(node, "translation").value_or(std::array<double, 3>{0, 0, 0});
  const auto q = number_list<4>(node, "rotation").value_or(std::array<double, 4>{0, 0, 0, 1});
  const Vector axis = {q[0], q[1], q[2]};
  const double w = q[3];
  const auto turned = [&](const Vector& v) {
    const Vector t = 2 * cross(axis, v);
    return v + w * t + cross(axis, t);
  };
  return {{turned({scale[0], 0, 0}), turned({0, scale[1], 0}), turned({0, 0, scale[2]})},
          {shift[0], shift[1], shift[2]}};
}

class GlbImporter {
 public:
  GlbImporter(std::string_view glb, const ImportLimits& limits, const Cancel& cancel)
      : document_(glb, cancel), limits_(limits), cancel_(cancel) {}

  ImportResult read() {
    refuse_extensions();
    for (std::size_t i = 0; i < document_.count("buffers"); ++i) {
      if (document_.entry("buffers", i).contains("uri")) {
        refuse_gltf("a buffer has a URI; only the binary chunk of the file itself is read");
      }
    }
    walk();
    if (!any_uv_) raw_.uvs.clear();
    if (!any_color_) raw_.colors.clear();
    return finish_import(std::move(raw_), MeshFormat::glb, limits_, cancel_);
  }

 private:
  void refuse_extensions() const {
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
      const auto found = document_.root().find(list);
      if (found == document_.root().end() || !found->is_array()) continue;
      for (const GltfJson& name : *found) {
        if (name == draco) refuse_draco();
        if (list == std::string_view("extensionsRequired") && name != "KHR_mesh_quantization" &&
            !(name.is_string() && name.get_ref<const std::string&>().starts_with("KHR_materials_"))) {
          refuse_gltf("it requires the extension " +
                      name.dump(-1, ' ', true, GltfJson::error_handler_t::replace).substr(0, 64) +
                      ", which is not supported");
        }
      }
    }
  }

  /// Nodes without a parent among the nodes, where no scene says with which to begin.
  std::vector<std::size_t> roots() const {
    if (document_.count("scenes") > 0) {
      return index_list(document_.entry("scenes", whole_number(document_.root(), "scene").value_or(0)), "nodes");
    }
    std::vector<bool> is_child(document_.count("nodes"));
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      for (const std::size_t child : index_list(document_.entry("nodes", i), "children")) {
        if (child < is_child.size()) is_child[child] = true;
      }
    }
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i]) roots.push_back(i);
    }
    return roots;
  }

  /// Every node once: the nodes of a glTF are trees, and a file where they are not is refused.
  void walk() {
    std::vector<bool> seen(document_.count("nodes"));
    std::vector<std::pair<std::size_t, Affine>> waiting;
    const auto push = [&](const std::vector<std::size_t>& nodes, const Affine& outer) {
      for (std::size_t k = nodes.size(); k-- > 0;) waiting.emplace_back(nodes[k], outer);
    };
    push(roots(), {});
    while (!waiting.empty()) {
      const auto [index, outer] = waiting.back();
      waiting.pop_back();
      const GltfJson& node = document_.entry("nodes", index);
      if (seen[index]) refuse_gltf("node " + std::to_string(index) + " is reached twice");
      seen[index] = true;
      const Affine place = after(outer, transform_of(node));
      if (const auto mesh = whole_number(node, "mesh")) add_mesh(document_.entry("meshes", *mesh), place);
      push(index_list(node, "children"), place);
    }
  }

  void add_mesh(const GltfJson& mesh, const Affine& place) {
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array()) refuse_gltf("a mesh has no primitives");
    for (const GltfJson& primitive : *primitives) {
      if (++primitives_ > most_primitives) throw GltfRefused{too_many(most_primitives, "primitives")};
      if (!primitive.is_object()) refuse_gltf("a primitive is no object");
      const auto extensions = primitive.find("extensions");
      if (extensions != primitive.end() && extensions->contains(draco)) refuse_draco();
      const std::size_t mode = whole_number(primitive, "mode").value_or(4);
      if (mode > 6) refuse_gltf("a primitive has an unknown mode");
      if (mode >= 4) add_primitive(primitive, mode, place);
    }
  }

  void add_primitive(const GltfJson& primitive, std::size_t mode, const Affine& place) {
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object()) refuse_gltf("a primitive has no attributes");
    const std::size_t position = needed_number(*attributes, "POSITION");
    const std::size_t base = raw_.positions.size(), count = document_.accessor_count(position);
    if (count > limits_.vertices - std::min(base, limits_.vertices)) {
      throw GltfRefused{too_many(limits_.vertices, "vertices")};
    }
    const std::vector<double> positions = document_.numbers(position, 3);
    for (std::size_t i = 0; i < count; ++i) raw_.positions.push_back(place(vector_at(positions, i)));
    add_attributes(*attributes, count, place);
    add_colors(primitive, *attributes, count);
    add_triangles(primitive, mode, base, count, place.mirrors());
  }

  static Vector vector_at(const std::vector<double>& numbers, std::size_t i) {
    return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  }

  /// The numbers of an attribute that is as long as the positions; empty when the primitive lacks it.
  std::vector<double> attribute(const GltfJson& attributes, const char* name, std::size_t width,
                                std::size_t count) const {
    const auto accessor = whole_number(attributes, name);
    if (!accessor) return {};
    if (document_.accessor_count(*accessor) != count) refuse_gltf(std::string(name) + " is not one per position");
    return document_.numbers(*accessor, width);
  }

  void add_attributes(const GltfJson& attributes, std::size_t count, const Affine& place) {
    const std::vector<double> normals = attribute(attributes, "NORMAL", 3, count);
    const double side = place.mirrors() ? -1 : 1;
    for (std::size_t i = 0; i < count; ++i) {
      raw_.normals.push_back(normals.empty() ? Vector{} : side * place.normal(vector_at(normals, i)));
    }
    const std::vector<double> uvs = attribute(attributes, "TEXCOORD_0", 2, count);
    any_uv_ = any_uv_ || !uvs.empty();
    for (std::size_t i = 0; i < count; ++i) {
      raw_.uvs.push_back(uvs.empty() ? std::array<double, 2>{0, 0} : std::array<double, 2>{uvs[2 * i], uvs[2 * i + 1]});
    }
  }

  std::array<double, 4> base_color(const GltfJson& primitive) const {
    const auto material = whole_number(primitive, "material");
    if (!material) return {1, 1, 1, 1};
    const GltfJson& description = document_.entry("materials", *material);
    const auto surface = description.find("pbrMetallicRoughness");
    if (surface == description.end() || !surface->is_object()) return {1, 1, 1, 1};
    return number_list<4>(*surface, "baseColorFactor").value_or(std::array<double, 4>{1, 1, 1, 1});
  }

  void add_colors(const GltfJson& primitive, const GltfJson& attributes, std::size_t count) {
    const std::array<double, 4> base = base_color(primitive);
    std::vector<double> colors;
    std::size_t width = 4;
    if (const auto accessor = whole_number(attributes, "COLOR_0")) {
      if (document_.accessor_count(*accessor) != count) refuse_gltf("COLOR_0 is not one per position");
      colors = document_.colors(*accessor, width);
    }
    any_color_ = any_color_ || !colors.empty() || base != std::array<double, 4>{1, 1, 1, 1};
    for (std::size_t i = 0; i < count; ++i) {
      std::array<float, 4> color{};
      for (std::size_t k = 0; k < 4; ++k) {
        const double own = colors.empty() || k >= width ? 1 : colors[width * i + k];
        color[k] = static_cast<float>(own * std::clamp(base[k], 0.0, 1.0));
      }
      raw_.colors.push_back(color);
    }
  }

  void add_triangles(const GltfJson& primitive, std::size_t mode, std::size_t base, std::size_t count, bool mirrored) {
    std::vector<std::uint32_t> corners;
    if (const auto accessor = whole_number(primitive, "indices")) {
      corners = document_.indices(*accessor, 3 * limits_.triangles + 2);
    } else {
      for (std::size_t i = 0; i < count; ++i) corners.push_back(static_cast<std::uint32_t>(i));
    }
    for (const std::uint32_t corner : corners) {
      if (corner >= count) {
        refuse_gltf("an index is " + std::to_string(corner) + ", but there are " + std::to_string(count) + " vertices");
      }
    }
    const std::size_t triangles =
        mode == 4 ? corners.size() / 3 : corners.size() - std::min<std::size_t>(corners.size(), 2);
    if (mode == 4 && corners.size() % 3 != 0) refuse_gltf("the indices of triangles do not come in threes");
    if (triangles > limits_.triangles - std::min(raw_.triangles.size(), limits_.triangles)) {
      throw GltfRefused{too_many(limits_.triangles, "triangles")};
    }
    for (std::size_t i = 0; i < triangles; ++i) {
      std::array<std::size_t, 3> at = {3 * i, 3 * i + 1, 3 * i + 2};
      if (mode == 5) at = {i, i + 1 + i % 2, i + 2 - i % 2};  // a strip turns over with every triangle
      if (mode == 6) at = {0, i + 1, i + 2};
      if (mirrored) std::swap(at[1], at[2]);
      std::array<std::uint32_t, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) triangle[k] = static_cast<std::uint32_t>(base) + corners[at[k]];
      raw_.triangles.push_back(triangle);
    }
  }

  GltfDocument document_;
  const ImportLimits& limits_;
  const Cancel& cancel_;
  RawMesh raw_;
  std::size_t primitives_ = 0;
  bool any_uv_ = false, any_color_ = false;
};

}  // namespace

ImportResult read_glb_mesh(std::string_view glb, const ImportLimits& limits, const Cancel& cancel) {
  try {
    return GlbImporter(glb, limits, cancel).read();
  } catch (const GltfRefused& refused) {
    return refused.error;
  } catch (const GltfJson::exception&) {
    return invalid_file("its JSON is not that of a glTF");
  }
}

}  // namespace dini

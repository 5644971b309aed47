#include "gltf/glb_import.h"

#include <algorithm>
#include <map>

#include "gltf/glb_left_out.h"
#include "gltf/glb_mesh_builder.h"
#include "gltf/gltf_extensions.h"

namespace dini {

namespace {

/// Meshes can be used by many nodes, so a small file could ask for endless looking around.
constexpr std::size_t most_primitives = 100'000;

class GlbImporter {
 public:
  GlbImporter(std::string_view glb, const ImportLimits& limits, const Cancel& cancel)
      : document_(glb, cancel),
        nodes_(document_),
        builder_(document_, limits, cancel),
        limits_(limits),
        cancel_(cancel) {}

  ImportResult read() {
    refuse_required_extensions(document_.root());
    walk();
    RawMesh raw = builder_.finish();
    left_out_.warn(document_, raw.warnings);
    return finish_import(std::move(raw), MeshFormat::glb, limits_, cancel_);
  }

 private:
  /// Those of the default scene, or all nodes without a parent where there is no scene.
  std::vector<std::size_t> roots() const {
    if (document_.count("scenes") == 0) return nodes_.roots();
    return index_list(document_.entry("scenes", whole_number(document_.root(), "scene").value_or(0)), "nodes");
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
      if (left_out_.is_hidden(node)) continue;
      const Affine place = after(outer, transform_of(node));
      if (const auto mesh = whole_number(node, "mesh")) add_mesh(*mesh, node, place);
      push(index_list(node, "children"), place);
    }
  }

  void add_mesh(std::size_t index, const GltfJson& node, const Affine& place) {
    const GltfJson& mesh = document_.entry("meshes", index);
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array()) {
      refuse_gltf("mesh " + std::to_string(index) + " has no primitives");
    }
    const auto skin = whole_number(node, "skin");
    const GltfPlace shown = {place, skin ? &pose(*skin) : nullptr};
    left_out_.add_mesh(index, mesh, node);
    for (std::size_t k = 0; k < primitives->size(); ++k) {
      if (++primitives_ > most_primitives) throw GltfRefused{too_many(most_primitives, "primitives")};
      const std::string name = "mesh " + std::to_string(index) + ", primitive " + std::to_string(k);
      try {
        if (!(*primitives)[k].is_object()) refuse_gltf("it is no object");
        builder_.add((*primitives)[k], shown, name);
      } catch (GltfRefused& refused) {
        if (refused.error.code == ImportError::Code::invalid) {
          refused.error.detail = name + ": " + refused.error.detail;
        }
        throw;
      }
    }
  }

  const std::vector<Affine>& pose(std::size_t skin) {
    const auto known = poses_.find(skin);
    return known != poses_.end() ? known->second : poses_[skin] = pose_of(document_, nodes_, skin);
  }

  GltfDocument document_;
  GltfNodes nodes_;
  GlbMeshBuilder builder_;
  GlbLeftOut left_out_;
  const ImportLimits& limits_;
  const Cancel& cancel_;
  std::map<std::size_t, std::vector<Affine>> poses_;
  std::size_t primitives_ = 0;
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

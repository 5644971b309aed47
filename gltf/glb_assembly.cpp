#include "gltf/glb_assembly.h"

#include <map>
#include <set>

#include "gltf/glb_container.h"

namespace dini {
namespace {

constexpr const char* draco = "KHR_draco_mesh_compression";

/// Thrown inside this file only.
struct NotAssembled {};

const Json& list_of(const Json& document, const char* name) {
  static const Json none = Json::array();
  const auto found = document.find(name);
  if (found == document.end()) return none;
  if (!found->is_array()) throw NotAssembled{};
  return *found;
}

/// Adds to the index that a member is, if there is one.
void shift(Json& object, const char* member, std::size_t by) {
  const auto found = object.find(member);
  if (found != object.end()) *found = found->get<std::size_t>() + by;
}

/// How much came before: what the indices of the next file begin at.
struct Counts {
  std::size_t accessors, views, materials, meshes, binary;
};

Json moved_primitive(Json primitive, const Counts& before) {
  for (auto& [name, accessor] : primitive.at("attributes").items())
    accessor = accessor.get<std::size_t>() + before.accessors;
  shift(primitive, "indices", before.accessors);
  shift(primitive, "material", before.materials);
  const auto extensions = primitive.find("extensions");
  if (extensions != primitive.end() && extensions->contains(draco))
    shift((*extensions)[draco], "bufferView", before.views);
  return primitive;
}

class Assembly {
 public:
  void add(const GlbItem& item) {
    roots_.push_back(nodes_.size());
    if (item.items.empty()) return add_file(item);
    const std::size_t place = add_node(item);
    for (const GlbItem& below : item.items) {
      nodes_[place]["children"].push_back(nodes_.size());
      add_file(below);
    }
  }

  std::string finish(const Json& about) && {
    Json document = {{"asset", {{"version", "2.0"}, {"generator", "Dini"}, {"extras", about}}},
                     {"scene", 0},
                     {"scenes", {{{"nodes", roots_}}}},
                     {"nodes", std::move(nodes_)}};
    const auto add_list = [&](const char* name, Json& list) {
      if (!list.empty()) document[name] = std::move(list);
    };
    add_list("accessors", accessors_);
    add_list("bufferViews", views_);
    add_list("materials", materials_);
    add_list("meshes", meshes_);
    if (!binary_.empty()) document["buffers"] = {{{"byteLength", binary_.size()}}};
    if (!used_.empty()) document["extensionsUsed"] = used_;
    if (!required_.empty()) document["extensionsRequired"] = required_;
    return join_glb(document.dump(), binary_);
  }

 private:
  /// What is repeated of a file whose meshes were taken.
  struct Source {
    Json nodes;
    Json roots;
    std::size_t meshes_before = 0;
  };

  /// A node with nothing below it yet; where it stands.
  std::size_t add_node(const GlbItem& item) {
    nodes_.push_back({{"name", item.name}});
    if (!item.extras.is_null()) nodes_.back()["extras"] = item.extras;
    return nodes_.size() - 1;
  }

  void add_file(const GlbItem& item) {
    const auto known = known_.find(item.glb);
    const Source& source =
        known != known_.end() ? known->second : known_.emplace(item.glb, take(item.glb)).first->second;
    const std::size_t place = add_node(item);
    const std::size_t first = nodes_.size();
    for (Json node : source.nodes) {
      shift(node, "mesh", source.meshes_before);
      if (node.contains("children")) {
        for (Json& child : node["children"]) child = child.get<std::size_t>() + first;
      }
      nodes_.push_back(std::move(node));
    }
    for (const Json& root : source.roots) nodes_[place]["children"].push_back(root.get<std::size_t>() + first);
  }

  Source take(std::string_view glb) {
    const auto chunks = split_glb(glb);
    if (!chunks) throw NotAssembled{};
    const Json document = Json::parse(chunks->json);
    const Counts before = {accessors_.size(), views_.size(), materials_.size(), meshes_.size(), binary_.size()};
    for (Json accessor : list_of(document, "accessors")) {
      shift(accessor, "bufferView", before.views);
      accessors_.push_back(std::move(accessor));
    }
    for (Json view : list_of(document, "bufferViews")) {
      view["byteOffset"] = view.value("byteOffset", std::size_t{0}) + before.binary;
      views_.push_back(std::move(view));
    }
    for (const Json& material : list_of(document, "materials")) materials_.push_back(material);
    for (Json mesh : list_of(document, "meshes")) {
      for (Json& primitive : mesh.at("primitives")) primitive = moved_primitive(std::move(primitive), before);
      meshes_.push_back(std::move(mesh));
    }
    for (const Json& name : list_of(document, "extensionsUsed")) used_.insert(name.get<std::string>());
    for (const Json& name : list_of(document, "extensionsRequired")) required_.insert(name.get<std::string>());
    binary_ += chunks->binary;
    binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
    const Json scene = document.at("scenes").at(document.value("scene", std::size_t{0}));
    return {list_of(document, "nodes"), list_of(scene, "nodes"), before.meshes};
  }

  std::map<std::string_view, Source> known_;
  Json accessors_ = Json::array(), views_ = Json::array(), materials_ = Json::array(), meshes_ = Json::array();
  Json nodes_ = Json::array();
  Json roots_ = Json::array();
  std::set<std::string> used_, required_;
  std::string binary_;
};

}  // namespace

std::optional<std::string> assemble_glb(std::span<const GlbItem> items, const Json& about) try {
  Assembly assembly;
  for (const GlbItem& item : items) assembly.add(item);
  std::string glb = std::move(assembly).finish(about);
  if (glb.empty()) return std::nullopt;
  return glb;
} catch (const NotAssembled&) {
  return std::nullopt;
} catch (const Json::exception&) {
  return std::nullopt;
}

}  // namespace dini

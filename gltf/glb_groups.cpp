#include "gltf/glb_groups.h"

#include <map>

#include "gltf/glb_container.h"
#include "gltf/glb_writer.h"

namespace dini {

namespace {

using Json = nlohmann::json;

/// Every part with its place among all parts as its name, by which its mesh is found again.
Scene flat_scene(const std::vector<GlbGroup>& groups, std::vector<std::string>& group_of_part) {
  Scene scene;
  for (const GlbGroup& group : groups) {
    for (const GlbChild& child : group.children) {
      for (const Part& part : child.parts) {
        scene.parts.push_back(part);
        scene.parts.back().name = std::to_string(group_of_part.size());
        group_of_part.push_back(group.name);
      }
    }
  }
  return scene;
}

/// A document with a root and nothing below it, as `encode_scene` starts one.
Json empty_document(const EncodeOptions& options) {
  constexpr double half_turn = 0.70710678118654757;
  return {{"asset", {{"version", "2.0"}, {"generator", options.generator}}},
          {"nodes", Json::array({{{"name", "Z up to Y up"}, {"rotation", {-half_turn, 0, 0, half_turn}}}})},
          {"scene", 0},
          {"scenes", Json::array({{{"nodes", Json::array({0})}}})}};
}

/// Puts the flat meshes of a document under the nodes of their groups.
class Grouping {
 public:
  Grouping(Json document, const std::vector<GlbGroup>& groups) : document_(std::move(document)), groups_(groups) {
    root_ = document_["nodes"][0];
    if (document_.contains("meshes")) {
      for (const Json& mesh : document_["meshes"]) flat_meshes_[mesh["name"]] = mesh;
    }
  }

  Json run() {
    nodes_.push_back(root_);
    Json below_root = Json::array();
    for (const GlbGroup& group : groups_) below_root.push_back(add_group(group));
    if (!below_root.empty()) nodes_[0]["children"] = std::move(below_root);
    document_["nodes"] = std::move(nodes_);
    if (!meshes_.empty()) document_["meshes"] = std::move(meshes_);
    return std::move(document_);
  }

 private:
  std::size_t add_group(const GlbGroup& group) {
    const std::size_t index = nodes_.size();
    nodes_.push_back({{"name", group.name}, {"extras", group.extras}});
    Json children = Json::array();
    for (const GlbChild& child : group.children) {
      if (const Json primitives = take_primitives(child); !primitives.empty()) {
        children.push_back(nodes_.size());
        nodes_.push_back({{"name", child.name}, {"extras", child.extras}, {"mesh", meshes_.size()}});
        meshes_.push_back({{"name", group.name + "." + child.name}, {"primitives", primitives}});
      }
    }
    if (children.empty()) {
      nodes_[index]["extras"]["drawable"] = false;
    } else {
      nodes_[index]["children"] = std::move(children);
    }
    return index;
  }

  /// The primitives of a child's parts, less those parts that had nothing to draw.
  Json take_primitives(const GlbChild& child) {
    Json primitives = Json::array();
    for (std::size_t part = 0; part < child.parts.size(); ++part, ++next_part_) {
      const auto found = flat_meshes_.find(std::to_string(next_part_));
      if (found == flat_meshes_.end()) continue;
      for (Json& primitive : found->second["primitives"]) primitives.push_back(std::move(primitive));
    }
    return primitives;
  }

  Json document_;
  const std::vector<GlbGroup>& groups_;
  Json root_;
  std::map<std::string, Json> flat_meshes_;
  Json nodes_ = Json::array();
  Json meshes_ = Json::array();
  std::size_t next_part_ = 0;
};

}  // namespace

EncodeResult<std::string> encode_groups(const std::vector<GlbGroup>& groups, const EncodeOptions& options,
                                        const Cancel& cancel) {
  std::vector<std::string> group_of_part;
  const Scene scene = flat_scene(groups, group_of_part);
  EncodeResult<EncodedScene> encoded = encode_scene(scene, options, cancel);
  if (auto* error = std::get_if<EncodeError>(&encoded)) {
    if (error->code == EncodeError::Code::empty) {
      return join_glb(Grouping(empty_document(options), groups).run(), {});
    }
    if (!error->part.empty()) error->part = group_of_part[std::stoul(error->part)];
    return std::move(*error);
  }
  const std::string& glb = std::get<EncodedScene>(encoded).glb;
  const auto chunks = split_glb(glb);
  Json document = chunks ? Json::parse(chunks->json, nullptr, false) : Json();
  std::string joined =
      document.is_object() ? join_glb(Grouping(std::move(document), groups).run(), chunks->binary) : "";
  if (joined.empty()) return EncodeError{EncodeError::Code::encoder_failed, "The file could not be written.", ""};
  return joined;
}

}  // namespace dini

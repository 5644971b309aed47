#include "graph/node_reader.h"

#include <algorithm>

#include "graph/json_reader.h"
#include "graph/literal.h"
#include "graph/names.h"
#include "graph/nearest.h"
#include "graph/registry.h"

namespace dini {

void NodeReader::add(std::string code, std::string pointer, std::string detail, std::string node, std::string port) {
  if (where_ == Where::group) node = port = "";
  problems.add({std::move(code), std::move(detail), std::move(node), std::move(port), std::move(pointer)});
}

bool NodeReader::object(const Json& json, const std::string& pointer, const std::vector<std::string>& known,
                        const std::string& node) {
  if (!json.is_object()) {
    add("type-mismatch", pointer, "got " + excerpt(json) + ", expected an object", node);
    return false;
  }
  bool all_known = true;
  for (const auto& [name, value] : json.items()) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    all_known = false;
    problems.add([&] {
      return Problem{"unknown-member", "unknown member " + excerpt(name) + did_you_mean(name, known),
                     where_ == Where::group ? "" : node, "", pointer + "/" + pointer_token(name)};
    });
  }
  return all_known;
}

bool NodeReader::identifier(const std::string& id, const std::string& pointer) {
  if (is_identifier(id)) return true;
  add("invalid-id", pointer,
      excerpt(id) + " is no name: a letter, then up to 63 letters, digits, underscores or hyphens");
  return false;
}

std::map<std::string, NodeEntry> NodeReader::read(const Json& json, const std::string& pointer, Where where) {
  std::map<std::string, NodeEntry> nodes;
  if (!json.is_object()) {
    add("type-mismatch", pointer, "nodes must be an object keyed by id");
    return nodes;
  }
  nodes_ += json.size();
  if (nodes_ > limits_.nodes) {
    add("limit-exceeded", pointer,
        "the graph has " + std::to_string(nodes_) + " nodes, at most " + std::to_string(limits_.nodes) +
            " are accepted");
    return nodes;
  }
  where_ = where;
  for (const auto& [id, value] : json.items()) {
    const std::string place = pointer + "/" + pointer_token(id);
    const bool is_known_path = where == Where::document_with_paths && is_path(id);
    if (is_known_path || identifier(id, place)) nodes.emplace(id, read_node(id, value, place));
  }
  where_ = Where::document;
  if (links_ > limits_.links) {
    add("limit-exceeded", pointer,
        "the graph has " + std::to_string(links_) + " links, at most " + std::to_string(limits_.links) +
            " are accepted");
  }
  return nodes;
}

NodeEntry NodeReader::read_node(const std::string& id, const Json& json, const std::string& pointer) {
  NodeEntry node;
  if (!object(json, pointer, {"type", "inputs", "bypass"}, id)) return node;
  if (!json.contains("type")) {
    add("required-member-missing", pointer, "the node has no \"type\"", id);
    return node;
  }
  if (!json["type"].is_string()) {
    add("type-mismatch", pointer + "/type", "got " + excerpt(json["type"]) + ", expected the id of a node type", id);
    return node;
  }
  node.type = json["type"].get<std::string>();
  if (json.contains("bypass")) {
    if (!json["bypass"].is_boolean()) {
      add("type-mismatch", pointer + "/bypass", "bypass must be true or false", id);
    } else {
      node.bypass = json["bypass"].get<bool>();
    }
  }
  if (!json.contains("inputs")) return node;
  if (!json["inputs"].is_object()) {
    add("type-mismatch", pointer + "/inputs", "inputs must be an object keyed by port", id);
    return node;
  }
  const NodeType* const type = registry_.find(node.type);
  for (const auto& [port, value] : json["inputs"].items()) {
    const Place place{id, port, type != nullptr ? type->find_input(port) : nullptr};
    node.inputs.emplace(port, read_input(place, value, pointer + "/inputs/" + pointer_token(port)));
  }
  return node;
}

InputEntry NodeReader::read_input(const Place& place, const Json& json, const std::string& pointer) {
  const auto is_object = [](const Json& item) { return item.is_object(); };
  const bool takes_several = place.card != nullptr && place.card->spec.takes_several;
  const bool list = json.is_array() && (takes_several || std::any_of(json.begin(), json.end(), is_object));
  InputEntry entry{{}, list};
  if (!list) {
    entry.items.push_back(read_item(place, json, pointer));
    return entry;
  }
  for (std::size_t i = 0; i < json.size(); ++i) {
    entry.items.push_back(read_item(place, json[i], pointer + "/" + std::to_string(i)));
  }
  return entry;
}

InputItem NodeReader::read_item(const Place& place, const Json& json, const std::string& pointer) {
  if (json.is_object()) return read_reference(place, json, pointer);
  return WrittenLiteral{json, place.card != nullptr ? read_literal(json, *place.card) : Readings{}};
}

InputItem NodeReader::read_reference(const Place& place, const Json& json, const std::string& pointer) {
  const bool in_group = where_ == Where::group;
  const auto text_of = [&](const char* member) -> const std::string* {
    return json.size() == 1 && json.contains(member) && json[member].is_string()
               ? &json[member].get_ref<const std::string&>()
               : nullptr;
  };
  if (const std::string* from = text_of("from")) {
    ++links_;
    return read_link(*from);
  }
  if (const std::string* name = text_of(in_group ? "input" : "parameter")) {
    if (in_group) return InputReference{*name};
    return ParameterReference{*name};
  }
  if (in_group && text_of("parameter") != nullptr) {
    add("unknown-parameter", pointer,
        "a group knows no parameters of the graph: give it an input, and set that to the parameter where the group "
        "is used");
  } else {
    add("type-mismatch", pointer,
        "got " + excerpt(json) + R"(, expected {"from": "node.output"} or )" +
            (in_group ? R"({"input": "name"})" : R"({"parameter": "name"})"),
        place.node, place.port);
  }
  return WrittenLiteral{json};
}

Link read_link(const std::string& text) {
  PlaceName place = place_name(text);
  return {std::move(place.node), std::move(place.output)};
}

}  // namespace dini

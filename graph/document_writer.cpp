#include "graph/document.h"

namespace dini {

namespace {

Json write_item(const InputItem& item) {
  if (const auto* link = std::get_if<Link>(&item)) {
    return {{"from", link->output.empty() ? link->node : link->node + "." + link->output}};
  }
  if (const auto* reference = std::get_if<ParameterReference>(&item)) return {{"parameter", reference->name}};
  if (const auto* reference = std::get_if<InputReference>(&item)) return {{"input", reference->name}};
  return std::get<WrittenLiteral>(item).written;
}

Json write_input(const InputEntry& entry) {
  if (!entry.list) return write_item(entry.items.front());
  Json list = Json::array();
  for (const InputItem& item : entry.items) list.push_back(write_item(item));
  return list;
}

template <class T>
void write_optional(Json& json, const char* name, const std::optional<T>& value) {
  if (value) json[name] = *value;
}

Json write_parameter(const Parameter& parameter) {
  Json json = {{"type", name(parameter.type)}, {"default", parameter.default_value.written}};
  write_optional(json, "min", parameter.minimum);
  write_optional(json, "max", parameter.maximum);
  write_optional(json, "step", parameter.step);
  write_optional(json, "unit", parameter.unit);
  write_optional(json, "label", parameter.label);
  write_optional(json, "description", parameter.description);
  if (!parameter.choices.empty()) json["choices"] = parameter.choices;
  return json;
}

Json write_node(const NodeEntry& node) {
  Json json = {{"type", node.type}};
  if (!node.inputs.empty()) {
    Json& inputs = json["inputs"] = Json::object();
    for (const auto& [port, entry] : node.inputs) inputs[port] = write_input(entry);
  }
  if (node.bypass) json["bypass"] = true;
  return json;
}

Json write_group(const GroupEntry& group) {
  Json json = {{"nodes", Json::object()}};
  write_optional(json, "label", group.label);
  write_optional(json, "description", group.description);
  for (const GroupInput& input : group.inputs) {
    Json& written = json["inputs"].emplace_back(Json{{"name", input.name}});
    write_optional(written, "default", input.default_value);
    write_optional(written, "label", input.label);
    write_optional(written, "description", input.description);
  }
  for (const GroupOutput& output : group.outputs) {
    json["outputs"].push_back({{"name", output.name}, {"from", write_item(output.from)["from"]}});
  }
  for (const auto& [id, node] : group.nodes) json["nodes"][id] = write_node(node);
  return json;
}

}  // namespace

Json write_document(const Document& document) {
  Json json = {{"format", document.format}, {"nodes", Json::object()}};
  write_optional(json, "$schema", document.schema);
  if (!document.meta.is_null()) json["meta"] = document.meta;
  if (!document.ui.is_null()) json["ui"] = document.ui;
  for (const auto& [id, node] : document.nodes) json["nodes"][id] = write_node(node);
  for (const auto& [name, group] : document.groups) json["groups"][name] = write_group(group);
  for (const auto& [name, parameter] : document.parameters) json["parameters"][name] = write_parameter(parameter);
  return json;
}

}  // namespace dini

#include "graph/document.h"

namespace dini {

namespace {

Json write_item(const InputItem& item) {
  if (const auto* link = std::get_if<Link>(&item)) {
    return {{"from", link->output.empty() ? link->node : link->node + "." + link->output}};
  }
  if (const auto* reference = std::get_if<ParameterReference>(&item)) return {{"parameter", reference->name}};
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

}  // namespace

Json write_document(const Document& document) {
  Json json = {{"format", 1}, {"nodes", Json::object()}};
  write_optional(json, "$schema", document.schema);
  if (!document.meta.is_null()) json["meta"] = document.meta;
  if (!document.ui.is_null()) json["ui"] = document.ui;
  for (const auto& [id, node] : document.nodes) json["nodes"][id] = write_node(node);
  for (const auto& [name, parameter] : document.parameters) json["parameters"][name] = write_parameter(parameter);
  return json;
}

}  // namespace dini

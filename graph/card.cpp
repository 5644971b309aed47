#include "graph/card.h"

#include <algorithm>

#include "graph/literal.h"

namespace dini {

namespace {

Json names_of(const std::vector<WireType>& types) {
  Json names = Json::array();
  for (const WireType type : types) names.push_back(name(type));
  return names;
}

Json handle_card(const Handle& handle) {
  if (handle.kind == Handle::Kind::position) return {{"kind", "position"}};
  Json json = {{"kind", handle.kind == Handle::Kind::direction ? "direction" : "radius"}};
  if (!handle.at.empty()) json["at"] = handle.at;
  if (!handle.normal.empty()) json["normal"] = handle.normal;
  return json;
}

Json degenerate_card(const std::vector<Degenerate>& cases) {
  Json list = Json::array();
  for (const Degenerate& one : cases) list.push_back({{"input", one.input}, {"result", one.result}});
  return list;
}

/// Nothing can be written at the input, whatever its types are.
bool links_only(const InputPort& port) {
  return port.keeps_apart || std::none_of(port.types.begin(), port.types.end(), has_literals);
}

/// The input names an axis that the node makes, and not one of its inputs that it uses up.
bool makes_axis(const NodeType& type, const InputPort& port) {
  return port.spec.is_axis_name && std::find(type.over.begin(), type.over.end(), port.name) == type.over.end();
}

/// The words of a name as people write them: "Clip radius" for clip_radius.
std::string title_of(const std::string& name) {
  std::string title = name;
  std::replace(title.begin(), title.end(), '_', ' ');
  if (!title.empty() && title.front() >= 'a' && title.front() <= 'z') title.front() += 'A' - 'a';
  return title;
}

Json input_card(const NodeType& type, const InputPort& port) {
  Json json = {{"name", port.name},
               {"title", port.spec.title_text.empty() ? title_of(port.name) : port.spec.title_text},
               {"types", names_of(port.types)},
               {"description", port.doc},
               {"required", port.required()},
               {"several", port.spec.takes_several}};
  if (!port.spec.default_value.is_null()) json["default"] = port.spec.default_value;
  if (!port.spec.unit_text.empty()) json["unit"] = port.spec.unit_text;
  if (port.spec.minimum) json["min"] = *port.spec.minimum;
  if (port.spec.maximum) json["max"] = *port.spec.maximum;
  if (port.spec.soft_minimum) json["soft_min"] = *port.spec.soft_minimum;
  if (port.spec.soft_maximum) json["soft_max"] = *port.spec.soft_maximum;
  if (!port.choices.empty()) json["choices"] = port.choices;
  if (links_only(port)) json["links_only"] = true;
  if (port.names_file) json["names_file"] = true;
  if (makes_axis(type, port)) json["makes_axis"] = true;
  if (port.spec.is_axis_name && port.spec.default_value == Json("")) {
    json["empty_means"] = makes_axis(type, port) ? "the id of this node" : "the last axis that is left";
  }
  if (port.spec.handle) json["handle"] = handle_card(*port.spec.handle);
  return json;
}

/// An output whose type follows the first input's, overload by overload.
bool follows_first_input(const NodeType& type, std::size_t output) {
  if (type.overloads.size() < 2) return false;
  for (const Overload& overload : type.overloads) {
    if (overload.inputs.empty() || overload.outputs[output].type != overload.inputs.front().type) return false;
  }
  return true;
}

}  // namespace

Json card(const NodeType& type) {
  Json inputs = Json::array();
  for (const InputPort& port : type.inputs) inputs.push_back(input_card(type, port));
  Json outputs = Json::array();
  for (std::size_t k = 0; k < type.outputs.size(); ++k) {
    Json output = {{"name", type.outputs[k].name},
                   {"title", title_of(type.outputs[k].name)},
                   {"types", names_of(type.outputs[k].types)},
                   {"description", type.outputs[k].doc}};
    if (follows_first_input(type, k)) output["same_as"] = type.inputs.front().name;
    outputs.push_back(std::move(output));
  }
  return {{"id", type.id},
          {"title", type.title},
          {"family", type.family},
          {"synonyms", type.synonyms},
          {"description", type.doc},
          {"source", type.source},
          {"details", type.details},
          {"version", type.version},
          {"inputs", std::move(inputs)},
          {"outputs", std::move(outputs)},
          {"degenerate", degenerate_card(type.degenerate)}};
}

Json wire_type_cards() {
  Json types = Json::array();
  for (const WireInfo& wire : wire_types()) {
    types.push_back({{"name", wire.name},
                     {"family", wire.family},
                     {"color", wire.color},
                     {"shape", wire.shape},
                     {"description", wire.doc},
                     {"literal_only", wire.literal_only}});
  }
  return types;
}

}  // namespace dini

#include "service/interface.h"

#include "graph/document.h"
#include "graph/json_reader.h"
#include "service/outputs.h"

namespace dini {

namespace {

Json numbers(std::size_t least, std::size_t most) {
  return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", least}, {"maxItems", most}};
}

Json value_schema(const Parameter& parameter) {
  switch (parameter.type) {
    case WireType::integer:
      return {{"type", "integer"}};
    case WireType::boolean:
      return {{"type", "boolean"}};
    case WireType::choice:
      return {{"type", "string"}, {"enum", parameter.choices}};
    case WireType::vector:
      return numbers(3, 3);
    case WireType::color:
      return numbers(3, 4);
    default:
      return {{"type", "number"}};
  }
}

Json parameter_schema(const Parameter& parameter) {
  Json schema = value_schema(parameter);
  schema["default"] = parameter.default_value.written;
  if (parameter.minimum) schema["minimum"] = *parameter.minimum;
  if (parameter.maximum) schema["maximum"] = *parameter.maximum;
  if (parameter.label) schema["title"] = *parameter.label;
  if (parameter.description) schema["description"] = *parameter.description;
  // What JSON Schema has no word for.
  if (parameter.step) schema["step"] = *parameter.step;
  if (parameter.unit) schema["unit"] = *parameter.unit;
  return schema;
}

Json value_from_text(const Json& schema, const std::string& text, const Limits& limits) {
  const std::string type = schema.value("type", "");
  if (type == "string") return text;
  const Result<Json> value = parse_json(type == "array" && !text.starts_with('[') ? "[" + text + "]" : text, limits);
  return value ? *value : Json(text);
}

}  // namespace

Json interface_of(const Registry& registry, const Document& document) {
  Json properties = Json::object();
  for (const auto& [name, parameter] : document.parameters) properties[name] = parameter_schema(parameter);
  return {{"parameters", {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}}},
          {"outputs", exports_of(registry, document).known}};
}

Json parameters_from_text(const Json& interface, const std::map<std::string, std::string>& texts,
                          const Limits& limits) {
  const Json& properties = interface.at("parameters").at("properties");
  Json values = Json::object();
  for (const auto& [name, text] : texts) {
    const auto schema = properties.find(name);
    values[name] = schema != properties.end() ? value_from_text(*schema, text, limits) : Json(text);
  }
  return values;
}

}  // namespace dini

#include "service/requests/schema.h"

namespace dini::schema {
namespace {

Json typed(const char* type, std::string doc) {
  Json schema = {{"type", type}};
  if (!doc.empty()) schema["description"] = std::move(doc);
  return schema;
}

}  // namespace

std::string graph_name_pattern(bool with_version) {
  return std::string("^[A-Za-z][A-Za-z0-9_-]{0,63}") + (with_version ? "(@[1-9][0-9]*)?$" : "$");
}

Json text(std::string doc) { return typed("string", std::move(doc)); }

Json word(std::vector<std::string> choices, std::string doc) {
  Json schema = typed("string", std::move(doc));
  schema["enum"] = std::move(choices);
  return schema;
}

Json number(std::string doc) { return typed("number", std::move(doc)); }

Json whole(std::string doc) {
  Json schema = typed("integer", std::move(doc));
  schema["minimum"] = 0;
  return schema;
}

Json yes_no(std::string doc) { return typed("boolean", std::move(doc)); }

Json list(Json items, std::string doc) {
  Json schema = typed("array", std::move(doc));
  schema["items"] = std::move(items);
  return schema;
}

Json map_of(Json values, std::string doc) {
  Json schema = typed("object", std::move(doc));
  schema["additionalProperties"] = std::move(values);
  return schema;
}

Json anything(std::string doc) { return {{"description", std::move(doc)}}; }

Json reference(std::string_view component, std::string doc) {
  Json schema = {{"$ref", "#/components/schemas/" + std::string(component)}};
  if (!doc.empty()) schema["description"] = std::move(doc);
  return schema;
}

Json object(const std::vector<Property>& properties, std::string doc) {
  Json schema = typed("object", std::move(doc));
  schema["properties"] = Json::object();
  Json required = Json::array();
  for (const Property& property : properties) {
    schema["properties"][property.name] = property.schema;
    if (!property.optional) required.push_back(property.name);
  }
  if (!required.empty()) schema["required"] = std::move(required);
  return schema;
}

}  // namespace dini::schema

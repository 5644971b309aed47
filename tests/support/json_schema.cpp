#include "tests/support/json_schema.h"

#include <algorithm>
#include <set>

namespace dini::support {
namespace {

bool has_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "number") return value.is_number();
  if (type == "integer") return value.is_number_integer();
  return false;
}

class Validator {
 public:
  explicit Validator(const Json& document) : document_(document) {}

  void check(const Json& value, const Json& schema, const std::string& place) {
    static const std::set<std::string> known = {
        "$ref",     "type",        "properties",           "required", "items", "enum", "minimum", "maximum", "default",
        "examples", "description", "additionalProperties", "anyOf"};
    for (const auto& [keyword, ignored] : schema.items()) {
      if (!known.contains(keyword)) say(place, "the schema has the unknown keyword " + keyword);
    }
    if (schema.contains("$ref")) {
      const auto pointer = schema["$ref"].get<std::string>().substr(1);
      check(value, document_.at(Json::json_pointer(pointer)), place);
    }
    if (schema.contains("anyOf") && std::ranges::none_of(schema["anyOf"], [&](const Json& each) {
          return departures(value, each, document_, place).empty();
        })) {
      say(place, "is none of the alternatives");
    }
    if (schema.contains("type") && !has_type(value, schema["type"])) {
      return say(place, "is no " + schema["type"].get<std::string>() + ": " + value.dump().substr(0, 80));
    }
    if (schema.contains("enum") && std::ranges::find(schema["enum"], value) == schema["enum"].end()) {
      say(place, value.dump() + " is none of " + schema["enum"].dump());
    }
    if (schema.contains("minimum") && value < schema["minimum"]) say(place, "is too small");
    if (schema.contains("maximum") && value > schema["maximum"]) say(place, "is too large");
    if (value.is_object()) check_members(value, schema, place);
    if (value.is_array() && schema.contains("items")) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        check(value[i], schema["items"], place + "/" + std::to_string(i));
      }
    }
  }

  std::vector<std::string> said() && { return std::move(said_); }

 private:
  void say(const std::string& place, const std::string& what) { said_.push_back(place + " " + what); }

  void check_members(const Json& value, const Json& schema, const std::string& place) {
    const Json properties = schema.value("properties", Json::object());
    for (const Json& name : schema.value("required", Json::array())) {
      if (!value.contains(name.get<std::string>())) say(place, "lacks " + name.get<std::string>());
    }
    const Json others = schema.value("additionalProperties", Json(!schema.contains("properties")));
    for (const auto& [name, member] : value.items()) {
      if (properties.contains(name)) {
        check(member, properties[name], place + "/" + name);
      } else if (others.is_object()) {
        check(member, others, place + "/" + name);
      } else if (others == false) {
        say(place, "has the undescribed member " + name);
      }
    }
  }

  const Json& document_;
  std::vector<std::string> said_;
};

}  // namespace

std::vector<std::string> departures(const Json& value, const Json& schema, const Json& document,
                                    const std::string& place) {
  Validator validator(document);
  validator.check(value, schema, place);
  return std::move(validator).said();
}

}  // namespace dini::support

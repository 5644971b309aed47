#include "service/document_schema.h"

#include <algorithm>
#include <map>
#include <string>

#include "geometry/length_unit.h"
#include "graph/groups.h"

namespace dini {
namespace {

constexpr const char* identifier = "[A-Za-z][A-Za-z0-9_-]{0,63}";
constexpr std::int64_t largest_exact_integer = 9007199254740991;

Json reference_to(const std::string& definition) { return {{"$ref", "#/$defs/" + definition}}; }

Json numbers(std::size_t least, std::size_t most) {
  return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", least}, {"maxItems", most}};
}

/// An object with these members and no others.
Json closed_object(Json properties, Json required) {
  Json schema = {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
  if (!required.empty()) schema["required"] = std::move(required);
  return schema;
}

/// One of several schemas, or the only one.
Json any_of(Json schemas) {
  if (schemas.size() == 1) return std::move(schemas.front());
  return {{"anyOf", std::move(schemas)}};
}

/// Literals of one wire type at an input; null for types that are never written. Ranges are those of numbers.
Json literal_schema(const std::string& type, const Json& input) {
  const auto ranged = [&](Json schema) {
    if (input.contains("min")) schema["minimum"] = input["min"];
    if (input.contains("max")) schema["maximum"] = input["max"];
    return schema;
  };
  if (type == "number") return ranged({{"type", "number"}});
  if (type == "integer") {
    return ranged({{"type", "integer"}, {"minimum", -largest_exact_integer}, {"maximum", largest_exact_integer}});
  }
  if (type == "vector" || type == "point") return reference_to("triple");
  if (type == "color") return reference_to("color");
  if (type == "boolean") return {{"type", "boolean"}};
  if (type == "text") return {{"type", "string"}};
  if (type == "choice") return {{"enum", input.value("choices", Json::array())}};
  return nullptr;
}

Json described(Json schema, const Json& card) {
  std::string text = card.value("description", "");
  if (card.contains("unit")) text += " Unit: " + card["unit"].get<std::string>() + ".";
  schema["description"] = std::move(text);
  return schema;
}

/// How nodes refer to values from elsewhere: those of a document to its parameters, those of a group to its inputs.
enum class Where { document, group };

class NodeSchemas {
 public:
  NodeSchemas(const Json& catalogue, Where where) : where_(where) {
    for (const Json& type : catalogue.at("types")) wired_[type.at("name")] = !type.value("literal_only", false);
  }

  /// A node of the type on this card.
  Json node(const Json& card) const {
    Json inputs = Json::object(), required = Json::array();
    for (const Json& input : card.at("inputs")) {
      inputs[input.at("name").get<std::string>()] = this->input(input);
      if (input.value("required", false)) required.push_back(input.at("name"));
    }
    Json schema = closed_object({{"type", {{"const", card.at("id")}}},
                                 {"inputs", closed_object(std::move(inputs), Json::array())},
                                 {"bypass", reference_to("bypass")}},
                                {"type"});
    schema["title"] = card.at("title");
    // A bypassed node passes on what its first input is linked to, and looks at nothing else.
    if (!card.at("inputs").empty()) {
      schema["if"] = {{"properties", {{"bypass", {{"const", true}}}}}, {"required", {"bypass"}}};
      schema["then"] = needing({card.at("inputs").front().at("name")});
      if (!required.empty()) schema["else"] = needing(std::move(required));
    }
    return described(std::move(schema), card);
  }

 private:
  static Json needing(Json inputs) {
    return {{"properties", {{"inputs", {{"required", std::move(inputs)}}}}}, {"required", {"inputs"}}};
  }

  Json input(const Json& card) const {
    Json literals = Json::array(), references = Json::array();
    for (const Json& type : card.at("types")) {
      Json literal = card.value("links_only", false) ? Json() : literal_schema(type, card);
      const bool repeated = std::find(literals.begin(), literals.end(), literal) != literals.end();
      if (!literal.is_null() && !repeated) literals.push_back(std::move(literal));
    }
    const Json& types = card.at("types");
    if (std::any_of(types.begin(), types.end(), [&](const Json& type) { return wired_.at(type); })) {
      references.push_back(reference_to("link"));
    }
    // An input of a group may bring a link as well.
    if (where_ == Where::group) references.push_back(reference_to("input_reference"));
    if (where_ == Where::document && !literals.empty()) references.push_back(reference_to("parameter_reference"));
    Json schema =
        card.value("several", false) ? several(literals, references, card) : any_of(joined(literals, references));
    if (card.contains("default")) schema["default"] = card["default"];
    return described(std::move(schema), card);
  }

  /// A list of items, or one item alone; but an array is always the list.
  static Json several(const Json& literals, const Json& references, const Json& card) {
    Json list = {{"type", "array"}, {"items", any_of(joined(literals, references))}};
    if (card.value("required", false)) list["minItems"] = 1;
    Json alone = Json::array();
    for (const Json& literal : literals) {
      if (!literal.contains("$ref")) alone.push_back(literal);
    }
    Json schemas = joined(alone, references);
    schemas.push_back(std::move(list));
    return any_of(std::move(schemas));
  }

  static Json joined(Json first, const Json& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }

  Where where_;
  std::map<std::string, bool> wired_;  ///< by wire type: whether links carry it
};

/// What a parameter of each type has besides its name.
Json parameter_schema() {
  const Json text = {{"type", "string"}};
  const auto number = [](const char* description) { return Json{{"type", "number"}, {"description", description}}; };
  Json schema = closed_object(
      {{"type", {{"enum", {"number", "integer", "boolean", "choice", "vector", "color"}}}},
       {"default", {{"description", "The value where a request gives none; within the bounds, one of the choices."}}},
       {"min", number("The least value that is accepted.")},
       {"max", number("The largest value that is accepted.")},
       {"step", {{"type", "number"}, {"exclusiveMinimum", 0}, {"description", "The step of a slider."}}},
       {"choices",
        {{"type", "array"}, {"items", text}, {"description", "The words of a choice; other types have none."}}},
       {"unit", text},
       {"label", text},
       {"description", text}},
      {"type", "default"});
  const auto rule = [](const char* type, Json value) {
    return Json{{"if", {{"properties", {{"type", {{"const", type}}}}}, {"required", {"type"}}}},
                {"then", {{"properties", {{"default", std::move(value)}}}}}};
  };
  Json rules = Json::array();
  for (const char* type : {"number", "integer", "boolean", "vector", "color"}) {
    rules.push_back(rule(type, literal_schema(type, Json::object())));
  }
  Json choice = rule("choice", {{"type", "string"}});
  choice["then"]["required"] = {"choices"};
  choice["then"]["properties"]["choices"] = {{"minItems", 1}};
  choice["else"] = {{"properties", {{"choices", {{"maxItems", 0}}}}}};
  rules.push_back(std::move(choice));
  schema["allOf"] = std::move(rules);
  schema["description"] = "What a form shows and a request may set.";
  return schema;
}

Json shared_definitions() {
  const std::string id = identifier;
  Json link =
      closed_object({{"from", {{"type", "string"}, {"pattern", "^" + id + "(/" + id + ")*(\\..+)?$"}}}}, {"from"});
  link["description"] = "The value of another node: \"node\" for its first output, \"node.output\" for any.";
  Json input = closed_object({{"input", {{"type", "string"}, {"pattern", "^" + id + "$"}}}}, {"input"});
  input["description"] = "What an instance gives to an input of the group around the node.";
  Json parameter = closed_object({{"parameter", {{"type", "string"}, {"pattern", "^" + id + "$"}}}}, {"parameter"});
  parameter["description"] = "The value of a parameter of the graph.";
  Json color = numbers(3, 4);
  color["items"] = {{"type", "number"}, {"minimum", 0}, {"maximum", 1}};
  color["description"] = "Linear red, green, blue and, if given, alpha, each 0 to 1.";
  return {{"link", std::move(link)},
          {"input_reference", std::move(input)},
          {"parameter_reference", std::move(parameter)},
          {"triple", numbers(3, 3)},
          {"color", std::move(color)},
          {"bypass", {{"type", "boolean"}, {"description", "The node passes on what its first input is linked to."}}},
          {"parameter", parameter_schema()}};
}

Json keyed(const char* description, Json values, bool by_path = false) {
  const std::string id = identifier;
  return {{"type", "object"},
          {"description", description},
          {"propertyNames", {{"pattern", "^" + id + (by_path ? "(/" + id + ")*$" : "$")}}},
          {"additionalProperties", std::move(values)}};
}

/// A node that stands for a group, whose inputs only the document knows.
Json instance_schema(Where where) {
  const Json no_reference = {{"not", {{"type", "object"}}}};
  Json references = Json::array({no_reference, reference_to("link")});
  references.push_back(reference_to(where == Where::group ? "input_reference" : "parameter_reference"));
  Json list = {{"type", "array"}, {"items", {{"anyOf", references}}}};
  Json schema = closed_object(
      {{"type", {{"type", "string"}, {"pattern", "^group/" + std::string(identifier) + "$"}}},
       {"inputs",
        {{"type", "object"},
         {"additionalProperties",
          {{"anyOf", {references[1], references[2], {{"type", {"number", "string", "boolean"}}}, std::move(list)}}}}}},
       {"bypass", reference_to("bypass")}},
      {"type"});
  schema["description"] = "An instance of a group of the document, with what it gives to its inputs.";
  return schema;
}

/// The definitions of all node types in the document ("node_..." and "node") or in groups ("group_node_...").
void add_nodes(const Json& catalogue, Where where, Json& definitions) {
  const std::string name = where == Where::group ? "group_node" : "node";
  const NodeSchemas schemas(catalogue, where);
  Json types = Json::array(), rules = Json::array();
  const auto add = [&](Json type, const std::string& definition, Json schema) {
    rules.push_back({{"if", {{"properties", {{"type", std::move(type)}}}, {"required", {"type"}}}},
                     {"then", reference_to(definition)}});
    definitions[definition] = std::move(schema);
  };
  for (const Json& card : catalogue.at("nodes")) {
    types.push_back(card.at("id"));
    add({{"const", card.at("id")}}, name + "_" + card.at("id").get<std::string>(), schemas.node(card));
  }
  const Json is_group = {{"pattern", "^group/"}};
  add(is_group, name + "_instance", instance_schema(where));
  definitions[name] = {{"type", "object"},
                       {"properties", {{"type", {{"anyOf", {{{"enum", std::move(types)}}, is_group}}}}}},
                       {"required", {"type"}},
                       {"allOf", std::move(rules)}};
}

Json sockets(Json item) { return {{"type", "array"}, {"items", std::move(item)}, {"maxItems", most_group_sockets}}; }

Json group_schema() {
  const Json text = {{"type", "string"}};
  const Json name = {{"type", "string"}, {"pattern", "^" + std::string(identifier) + "$"}};
  Json usual = {{"description", "A literal: what an instance gives that leaves the input out."},
                {"type", {"number", "string", "boolean", "array"}},
                {"items", {{"not", {{"type", "object"}}}}}};
  Json input =
      closed_object({{"name", name}, {"default", std::move(usual)}, {"label", text}, {"description", text}}, {"name"});
  Json output = closed_object({{"name", name}, {"from", text}}, {"name", "from"});
  output["properties"]["from"]["description"] = "\"node\" or \"node.output\", of a node of the group.";
  Json schema = closed_object({{"label", text},
                               {"description", text},
                               {"inputs", sockets(std::move(input))},
                               {"outputs", sockets(std::move(output))},
                               {"nodes", keyed("The nodes, by id.", reference_to("group_node"))}},
                              {"nodes"});
  schema["description"] = "Nodes that stand together wherever a node of type \"group/<name>\" is.";
  return schema;
}

}  // namespace

Json document_schema(const Json& catalogue) {
  Json definitions = shared_definitions();
  add_nodes(catalogue, Where::document, definitions);
  add_nodes(catalogue, Where::group, definitions);
  definitions["group"] = group_schema();
  Json schema = closed_object(
      {{"$schema", {{"type", "string"}, {"description", "Where this schema is, for editors; nothing else reads it."}}},
       {"format", {{"enum", {1, 2}}, {"description", "The version of the format; groups and paths as ids need 2."}}},
       {"meta",
        {{"description",
          "Anything about the graph, such as its title; never part of an evaluation, but for the unit of files."},
         {"properties",
          {{"unit",
            {{"enum", Json(length_unit_names)},
             {"description", "What coordinates count; without it they are meters."}}}}}}},
       {"parameters", keyed("What a form shows and a request may set, by name.", reference_to("parameter"))},
       {"groups", keyed("Nodes that stand together at several places, by name.", reference_to("group"))},
       {"nodes", keyed("The nodes, by id.", reference_to("node"), true)},
       {"ui", {{"description", "What the page remembers, such as places of nodes; never part of an evaluation."}}}},
      {"format", "nodes"});
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["$id"] = "urn:dini:schema:graph-1";
  schema["title"] = "Dini graph document, formats 1 and 2";
  schema["if"] = {{"properties", {{"format", {{"const", 1}}}}}};
  schema["then"] = {
      {"properties",
       {{"groups", {{"maxProperties", 0}}}, {"nodes", {{"propertyNames", {{"not", {{"pattern", "/"}}}}}}}}}};
  schema["$defs"] = std::move(definitions);
  return schema;
}

}  // namespace dini

#include <algorithm>

#include "graph/document.h"
#include "graph/json_reader.h"
#include "graph/literal.h"
#include "graph/node_reader.h"
#include "graph/parameters.h"

namespace dini {

namespace {

using Where = NodeReader::Where;

class DocumentReader {
 public:
  DocumentReader(const Limits& limits, const Registry& registry) : nodes_(limits, registry) {}

  Result<Document> read(const Json& json) {
    Document document;
    if (!nodes_.object(json, "", {"$schema", "format", "meta", "parameters", "groups", "nodes", "ui"}))
      return std::move(nodes_.problems).take();
    read_format(json, document);
    read_schema(json, document);
    if (json.contains("meta")) document.meta = json["meta"];
    if (json.contains("ui")) document.ui = json["ui"];
    if (json.contains("parameters")) read_parameters(json["parameters"], document);
    if (json.contains("groups")) read_groups(json["groups"], document);
    if (!json.contains("nodes")) {
      add("required-member-missing", "", "the document has no \"nodes\"");
    } else {
      document.nodes =
          nodes_.read(json["nodes"], "/nodes", document.format == 1 ? Where::document : Where::document_with_paths);
    }
    if (!nodes_.problems.empty()) return std::move(nodes_.problems).take();
    return document;
  }

 private:
  void add(std::string code, std::string pointer, std::string detail) {
    nodes_.add(std::move(code), std::move(pointer), std::move(detail));
  }

  void read_format(const Json& json, Document& document) {
    if (!json.contains("format")) {
      add("required-member-missing", "", "the document has no \"format\"; this version reads formats 1 and 2");
    } else if (json["format"] != 1 && json["format"] != 2) {
      add("unsupported-format", "/format", "got " + excerpt(json["format"]) + ", this version reads formats 1 and 2");
    } else {
      document.format = json["format"].get<int>();
    }
  }

  void read_schema(const Json& json, Document& document) {
    if (!json.contains("$schema")) return;
    const Json& schema = json["$schema"];
    if (schema.is_string()) {
      document.schema = schema.get<std::string>();
    } else {
      add("type-mismatch", "/$schema", "got " + excerpt(schema) + ", expected the address of a schema");
    }
  }

  void read_parameters(const Json& json, Document& document) {
    if (!json.is_object()) {
      add("type-mismatch", "/parameters", "parameters must be an object keyed by name");
      return;
    }
    for (const auto& [name, value] : json.items()) {
      const std::string pointer = "/parameters/" + pointer_token(name);
      if (!nodes_.identifier(name, pointer)) continue;
      Result<Parameter> parameter = read_parameter(value, pointer);
      if (parameter) {
        document.parameters.emplace(name, std::move(*parameter));
      } else {
        nodes_.problems.add(std::move(parameter).problems());
      }
    }
  }

  void read_groups(const Json& json, Document& document) {
    if (!json.is_object()) {
      add("type-mismatch", "/groups", "groups must be an object keyed by name");
      return;
    }
    if (document.format == 1 && !json.empty()) {
      // An older version would call the member unknown, and say nothing of the format that has it.
      nodes_.problems.add({.code = "unsupported-format",
                           .detail = "groups are of format 2, and the document says that it has format 1",
                           .pointer = "/format",
                           .fix = {{{"op", "replace"}, {"path", "/format"}, {"value", 2}}}});
    }
    for (const auto& [name, value] : json.items()) {
      const std::string pointer = "/groups/" + pointer_token(name);
      if (nodes_.identifier(name, pointer)) document.groups.emplace(name, read_group(value, pointer));
    }
  }

  GroupEntry read_group(const Json& json, const std::string& pointer) {
    GroupEntry group;
    if (!nodes_.object(json, pointer, {"label", "description", "inputs", "outputs", "nodes"})) return group;
    group.label = text_at(json, "label", pointer);
    group.description = text_at(json, "description", pointer);
    each(json, "inputs", pointer, [&](const Json& input, const std::string& place) {
      if (!nodes_.object(input, place, {"name", "default", "label", "description"})) return;
      GroupInput read{name_of(input, place, names_of(group.inputs)), std::nullopt, text_at(input, "label", place),
                      text_at(input, "description", place)};
      if (input.contains("default")) {
        read.default_value = input["default"];
        if (!is_literal(input["default"])) {
          add("type-mismatch", place + "/default",
              "got " + excerpt(input["default"]) + ", expected a literal: an instance that leaves it out gives that");
        }
      }
      group.inputs.push_back(std::move(read));
    });
    each(json, "outputs", pointer, [&](const Json& output, const std::string& place) {
      if (!nodes_.object(output, place, {"name", "from"})) return;
      GroupOutput read{name_of(output, place, names_of(group.outputs)), {}};
      const std::optional<std::string> from = text_at(output, "from", place);
      if (!output.contains("from")) add("required-member-missing", place, "the output has no \"from\"");
      if (from) read.from = read_link(*from);
      group.outputs.push_back(std::move(read));
    });
    if (!json.contains("nodes")) {
      add("required-member-missing", pointer, "the group has no \"nodes\"");
    } else {
      group.nodes = nodes_.read(json["nodes"], pointer + "/nodes", Where::group);
    }
    return group;
  }

  static bool is_literal(const Json& json) {
    const auto is_object = [](const Json& item) { return item.is_object(); };
    return !json.is_object() && !json.is_null() &&
           !(json.is_array() && std::any_of(json.begin(), json.end(), is_object));
  }

  template <class Named>
  static std::vector<std::string> names_of(const std::vector<Named>& all) {
    std::vector<std::string> names;
    for (const Named& one : all) names.push_back(one.name);
    return names;
  }

  /// Calls `read` with each item of a list and its pointer.
  template <class Read>
  void each(const Json& json, const char* member, const std::string& pointer, Read read) {
    const auto list = json.find(member);
    if (list == json.end()) return;
    const std::string place = pointer + "/" + member;
    if (!list->is_array()) {
      add("type-mismatch", place, "got " + excerpt(*list) + ", expected a list, in the order of the sockets");
      return;
    }
    for (std::size_t i = 0; i < list->size(); ++i) read((*list)[i], place + "/" + std::to_string(i));
  }

  std::optional<std::string> text_at(const Json& json, const char* member, const std::string& pointer) {
    const auto text = json.find(member);
    if (text == json.end()) return std::nullopt;
    if (text->is_string()) return text->get<std::string>();
    add("type-mismatch", pointer + "/" + member, "got " + excerpt(*text) + ", expected a text");
    return std::nullopt;
  }

  std::string name_of(const Json& json, const std::string& pointer, const std::vector<std::string>& taken) {
    if (!json.contains("name")) add("required-member-missing", pointer, "it has no \"name\"");
    const std::string name = text_at(json, "name", pointer).value_or("");
    if (!json.contains("name") || !json["name"].is_string()) return name;
    if (nodes_.identifier(name, pointer + "/name") && std::find(taken.begin(), taken.end(), name) != taken.end()) {
      add("invalid-id", pointer + "/name", "the name " + excerpt(name) + " is taken by another one before it");
    }
    return name;
  }

  NodeReader nodes_;
};

}  // namespace

bool is_identifier(std::string_view text) {
  constexpr std::size_t longest = 64;
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto other = [](char c) { return (c >= '0' && c <= '9') || c == '_' || c == '-'; };
  return !text.empty() && text.size() <= longest && letter(text[0]) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return letter(c) || other(c); });
}

bool is_path(std::string_view text) {
  for (std::size_t slash = text.find('/'); slash != std::string_view::npos; slash = text.find('/')) {
    if (!is_identifier(text.substr(0, slash))) return false;
    text = text.substr(slash + 1);
  }
  return is_identifier(text);
}

Result<Document> read_document(const Json& json, const Limits& limits, const Registry& registry) {
  return DocumentReader(limits, registry).read(json);
}

}  // namespace dini

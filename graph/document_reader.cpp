#include <algorithm>
#include <cctype>

#include "graph/document.h"
#include "graph/json_reader.h"
#include "graph/literal.h"
#include "graph/nearest.h"
#include "graph/parameters.h"
#include "graph/registry.h"

namespace dini {

namespace {

class DocumentReader {
 public:
  DocumentReader(const Limits& limits, const Registry& registry) : limits_(limits), registry_(registry) {}

  Result<Document> read(const Json& json) {
    Document document;
    if (!object(json, "", {"$schema", "format", "meta", "parameters", "nodes", "ui"}))
      return std::move(problems_).take();
    read_format(json);
    read_schema(json, document);
    if (json.contains("meta")) document.meta = json["meta"];
    if (json.contains("ui")) document.ui = json["ui"];
    if (json.contains("parameters")) read_parameters(json["parameters"], document);
    if (!json.contains("nodes")) {
      add("required-member-missing", "", "the document has no \"nodes\"");
    } else {
      read_nodes(json["nodes"], document);
    }
    if (!problems_.empty()) return std::move(problems_).take();
    return document;
  }

 private:
  void add(std::string code, std::string pointer, std::string detail, std::string node = "", std::string port = "") {
    problems_.add({std::move(code), std::move(detail), std::move(node), std::move(port), std::move(pointer)});
  }

  /// True when `json` is an object with no other members than `known`; adds a problem for each that is not.
  bool object(const Json& json, const std::string& pointer, const std::vector<std::string>& known,
              const std::string& node = "") {
    if (!json.is_object()) {
      add("type-mismatch", pointer, "got " + excerpt(json) + ", expected an object", node);
      return false;
    }
    bool all_known = true;
    for (const auto& [name, value] : json.items()) {
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      all_known = false;
      problems_.add([&] {
        return Problem{"unknown-member", "unknown member " + excerpt(name) + did_you_mean(name, known), node, "",
                       pointer + "/" + pointer_token(name)};
      });
    }
    return all_known;
  }

  bool identifier(const std::string& id, const std::string& pointer) {
    if (is_identifier(id)) return true;
    add("invalid-id", pointer,
        excerpt(id) + " is no name: a letter, then up to 63 letters, digits, underscores or hyphens");
    return false;
  }

  void read_format(const Json& json) {
    if (!json.contains("format")) {
      add("required-member-missing", "", "the document has no \"format\"; this version reads format 1");
    } else if (json["format"] != 1) {
      add("unsupported-format", "/format", "got " + excerpt(json["format"]) + ", this version reads format 1");
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
      if (!identifier(name, pointer)) continue;
      Result<Parameter> parameter = read_parameter(value, pointer);
      if (parameter) {
        document.parameters.emplace(name, std::move(*parameter));
      } else {
        problems_.add(std::move(parameter).problems());
      }
    }
  }

  void read_nodes(const Json& json, Document& document) {
    if (!json.is_object()) {
      add("type-mismatch", "/nodes", "nodes must be an object keyed by id");
      return;
    }
    if (json.size() > limits_.nodes) {
      add("limit-exceeded", "/nodes",
          "the graph has " + std::to_string(json.size()) + " nodes, at most " + std::to_string(limits_.nodes) +
              " are accepted");
      return;
    }
    for (const auto& [id, value] : json.items()) {
      const std::string pointer = "/nodes/" + pointer_token(id);
      if (identifier(id, pointer)) document.nodes.emplace(id, read_node(id, value, pointer));
    }
    if (links_ > limits_.links) {
      add("limit-exceeded", "/nodes",
          "the graph has " + std::to_string(links_) + " links, at most " + std::to_string(limits_.links) +
              " are accepted");
    }
  }

  NodeEntry read_node(const std::string& id, const Json& json, const std::string& pointer) {
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

  /// Where something is given.
  struct Place {
    const std::string& node;
    const std::string& port;
    const InputPort* card;  ///< null for an unknown one
  };

  InputEntry read_input(const Place& place, const Json& json, const std::string& pointer) {
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

  InputItem read_item(const Place& place, const Json& json, const std::string& pointer) {
    if (!json.is_object()) {
      return WrittenLiteral{json, place.card != nullptr ? read_literal(json, *place.card) : Readings{}};
    }
    const bool link = json.contains("from");
    const char* const member = link ? "from" : "parameter";
    if (json.size() != 1 || !json.contains(member) || !json[member].is_string()) {
      add("type-mismatch", pointer,
          "got " + excerpt(json) + R"(, expected {"from": "node.output"} or {"parameter": "name"})", place.node,
          place.port);
      return WrittenLiteral{json};
    }
    const auto& text = json[member].get_ref<const std::string&>();
    if (!link) return ParameterReference{text};
    ++links_;
    const std::size_t period = text.find('.');
    if (period == std::string::npos) return Link{text, ""};
    return Link{text.substr(0, period), text.substr(period + 1)};
  }

  const Limits& limits_;
  const Registry& registry_;
  ProblemCollector problems_;
  std::size_t links_ = 0;
};

}  // namespace

bool is_identifier(std::string_view text) {
  constexpr std::size_t longest = 64;
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto other = [](char c) { return (c >= '0' && c <= '9') || c == '_' || c == '-'; };
  return !text.empty() && text.size() <= longest && letter(text[0]) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return letter(c) || other(c); });
}

Result<Document> read_document(const Json& json, const Limits& limits, const Registry& registry) {
  return DocumentReader(limits, registry).read(json);
}

}  // namespace dini

#include "service/example_markdown.h"

namespace dini {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// JSON in one line with a space after each comma and colon, which is easier to read than what `dump` writes.
std::string spaced(const OrderedJson& value) {
  if (!value.is_structured()) return value.dump();
  std::string inside;
  for (const auto& [name, member] : value.items()) {
    if (!inside.empty()) inside += ", ";
    if (value.is_object()) inside += OrderedJson(name).dump() + ": ";
    inside += spaced(member);
  }
  return value.is_object() ? "{" + inside + "}" : "[" + inside + "]";
}

}  // namespace

std::string example_picture(const NodeExamples& examples, const std::string& node) {
  const auto found = examples.find(node);
  if (found == examples.end()) return "";
  const OrderedJson meta = found->second.value("meta", OrderedJson::object());
  const std::string title = meta.value("title", node);
  return "![" + title + "](images/nodes/" + node + ".png)\n\n[" + title + "](../examples/nodes/" + node +
         ".json): " + meta.value("description", "") + "\n\n";
}

std::string example_graph(const NodeExamples& examples, const std::string& node) {
  const auto found = examples.find(node);
  if (found == examples.end()) return "";
  const OrderedJson nodes = found->second.value("nodes", OrderedJson::object());
  std::string lines;
  for (const auto& [id, entry] : nodes.items()) {
    lines += (lines.empty() ? "  " : ",\n  ") + OrderedJson(id).dump() + ": " + spaced(entry);
  }
  return "```json\n{\n" + lines + "\n}\n```\n\n";
}

}  // namespace dini

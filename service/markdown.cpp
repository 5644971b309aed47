#include "service/markdown.h"

#include <cctype>
#include <string_view>
#include <vector>

namespace dini {
namespace {

std::string text_of(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Inside a table cell a bar would end the cell and a line break the row.
std::string cell(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '|') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

std::string joined(const Json& object, const char* name, std::string_view separator) {
  std::string result;
  const auto found = object.find(name);
  if (found == object.end() || !found->is_array()) return result;
  for (const Json& item : *found) {
    if (!result.empty()) result += separator;
    result += item.is_string() ? item.get<std::string>() : item.dump();
  }
  return result;
}

std::string types_of(const Json& port) {
  const std::string choices = joined(port, "choices", "`, `");
  if (!choices.empty()) return "one of `" + choices + "`";
  return joined(port, "types", ", ") + (port.value("several", false) ? ", several" : "");
}

std::string default_of(const Json& input) {
  if (input.value("required", false)) return "required";
  const auto found = input.find("default");
  if (found == input.end() || found->is_null()) return "";
  return "`" + found->dump() + "`";
}

/// The hard bounds, and the soft ones a slider has when they are narrower.
std::string range_of(const Json& input) {
  const auto bounds = [&](const char* low, const char* high) {
    const bool has_low = input.contains(low);
    const bool has_high = input.contains(high);
    if (has_low && has_high) return input.at(low).dump() + " to " + input.at(high).dump();
    if (has_low) return "from " + input.at(low).dump();
    return has_high ? "up to " + input.at(high).dump() : std::string();
  };
  const std::string hard = bounds("min", "max");
  const std::string soft = bounds("soft_min", "soft_max");
  if (hard.empty() || soft.empty() || hard == soft) return hard.empty() ? soft : hard;
  return hard + " (slider " + soft + ")";
}

void write_inputs(const Json& inputs, std::string& page) {
  if (inputs.empty()) return;
  page += "| input | type | default | range | unit | what it does |\n|---|---|---|---|---|---|\n";
  for (const Json& input : inputs) {
    page += "| `" + text_of(input, "name") + "` | " + cell(types_of(input)) + " | " + cell(default_of(input)) + " | " +
            cell(range_of(input)) + " | " + cell(text_of(input, "unit")) + " | " + cell(text_of(input, "description")) +
            " |\n";
  }
  page += "\n";
}

void write_degenerate(const Json& cases, std::string& page) {
  if (cases.empty()) return;
  page += "| singular input | what happens |\n|---|---|\n";
  for (const Json& one : cases) {
    page += "| " + cell(text_of(one, "input")) + " | " + cell(text_of(one, "result")) + " |\n";
  }
  page += "\n";
}

void write_outputs(const Json& outputs, std::string& page) {
  if (outputs.empty()) return;
  page += "| output | type | what it is |\n|---|---|---|\n";
  for (const Json& output : outputs) {
    const std::string same = text_of(output, "same_as");
    const std::string types = same.empty() ? types_of(output) : "as `" + same + "`";
    page +=
        "| `" + text_of(output, "name") + "` | " + cell(types) + " | " + cell(text_of(output, "description")) + " |\n";
  }
  page += "\n";
}

std::string heading(const Json& node) { return text_of(node, "title") + " (`" + text_of(node, "id") + "`)"; }

/// What a reader of Markdown makes of a heading for links to it: lower case, hyphens for spaces, no other signs.
std::string anchor(const std::string& heading) {
  std::string result;
  for (const char c : heading) {
    if (c == ' ') result += '-';
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-')
      result += static_cast<char>(std::tolower(c));
  }
  return result;
}

/// One line of links to the nodes of a family.
void write_family(const Json& family, const std::vector<Json>& nodes, std::string& page) {
  page += "## " + text_of(family, "title") + "\n\n";
  for (const Json& node : nodes) {
    page += (&node == &nodes.front() ? "[" : " · [") + text_of(node, "title") + "](#" + anchor(heading(node)) + ")";
  }
  page += "\n\n";
}

void write_node(const Json& node, const NodeExamples& examples, std::string& page) {
  page += "### " + heading(node) + "\n\n" + text_of(node, "description") + "\n\n";
  const std::string synonyms = joined(node, "synonyms", ", ");
  if (!synonyms.empty()) page += "Found as: " + synonyms + ".\n\n";
  const std::string details = text_of(node, "details");
  if (!details.empty()) page += details + "\n\n";
  const std::string source = text_of(node, "source");
  if (!source.empty()) page += "Source: " + source + "\n\n";
  page += example_picture(examples, text_of(node, "id"));
  write_inputs(node.value("inputs", Json::array()), page);
  write_outputs(node.value("outputs", Json::array()), page);
  write_degenerate(node.value("degenerate", Json::array()), page);
  page += example_graph(examples, text_of(node, "id"));
}

}  // namespace

std::string nodes_markdown(const Json& catalogue, const NodeExamples& examples) {
  std::string page =
      "# Nodes\n\nThis page is written by `dini nodes --markdown` from the declarations of the nodes; do not edit "
      "it.\n\nEach node has a small graph of its own, shown below its tables with the model that it makes; an input "
      "that "
      "is not\nwritten there has its default. `dini eval examples/nodes/boost.json -o boost.glb` writes such a "
      "model.\n\n";
  for (const Json& family : catalogue.value("families", Json::array())) {
    std::vector<Json> nodes;
    for (const Json& node : catalogue.value("nodes", Json::array())) {
      if (text_of(node, "family") == text_of(family, "name")) nodes.push_back(node);
    }
    write_family(family, nodes, page);
    for (const Json& node : nodes) write_node(node, examples, page);
  }
  page.erase(page.find_last_not_of('\n') + 1);
  return page + "\n";
}

}  // namespace dini

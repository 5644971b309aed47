#include "graph/origins.h"

#include <optional>

namespace dini {

namespace {

/// The output that made what stands at `source`. A bypassed node stands for its own source already.
Source maker_of(const Plan& plan, Source source) {
  for (;;) {
    const PlannedNode& node = plan.nodes[source.node];
    if (node.bypass || !node.type->passes_on || node.inputs.front().items.size() != 1) return source;
    const auto* next = std::get_if<Source>(&node.inputs.front().items.front().from);
    if (next == nullptr) return source;
    source = *next;
  }
}

/// What is said of a problem names so many wires and parameters; a longer sentence helps nobody.
constexpr std::size_t most_described = 3;
constexpr std::size_t most_named = 6;

/// "skin (Surface), which depends on the parameters bottom (Bottom) and top".
std::string description_of(const Plan& plan, std::size_t index, const Document& document) {
  const PlannedNode& node = plan.nodes[index];
  std::string text = node.id + " (" + node.type->title + ")";
  const std::set<std::string> parameters = parameters_behind(plan, index);
  std::size_t left = parameters.size(), named = 0;
  if (left > 0) text += left == 1 ? ", which depends on the parameter " : ", which depends on the parameters ";
  for (const std::string& name : parameters) {
    if (++named > most_named) return text + std::to_string(left) + " more";
    text += name;
    const auto parameter = document.parameters.find(name);
    if (parameter != document.parameters.end() && parameter->second.label)
      text += " (" + *parameter->second.label + ")";
    if (--left > 0) text += left == 1 || named == most_named ? " and " : ", ";
  }
  return text;
}

}  // namespace

void find_origins(Plan& plan, const Document& document) {
  for (PlannedNode& node : plan.nodes) {
    if (node.bypass || !node.type->names_parts) continue;
    std::size_t described = 0;
    for (PlannedInput& input : node.inputs) {
      for (PlannedItem& item : input.items) {
        const auto* source = std::get_if<Source>(&item.from);
        if (source == nullptr) continue;
        const Source made = maker_of(plan, *source);
        const PlannedNode& maker = plan.nodes[made.node];
        const std::string output = made.output == 0 ? "" : "." + maker.type->outputs[made.output].name;
        item.origin.part = maker.id + output;
        if (described++ < most_described) item.origin.description = description_of(plan, made.node, document);
      }
    }
  }
}

}  // namespace dini

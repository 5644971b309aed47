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

/// "skin (Surface), which depends on the parameters bottom (Bottom) and top".
std::string description_of(const PlannedNode& node, const Document& document) {
  std::string text = node.id + " (" + node.type->title + ")";
  std::size_t left = node.parameters.size();
  if (left > 0) text += left == 1 ? ", which depends on the parameter " : ", which depends on the parameters ";
  for (const std::string& name : node.parameters) {
    text += name;
    const auto parameter = document.parameters.find(name);
    if (parameter != document.parameters.end() && parameter->second.label)
      text += " (" + *parameter->second.label + ")";
    if (--left > 0) text += left == 1 ? " and " : ", ";
  }
  return text;
}

}  // namespace

void find_origins(Plan& plan, const Document& document) {
  for (PlannedNode& node : plan.nodes) {
    if (node.bypass || !node.type->names_parts) continue;
    for (PlannedInput& input : node.inputs) {
      for (PlannedItem& item : input.items) {
        const auto* source = std::get_if<Source>(&item.from);
        if (source == nullptr) continue;
        const Source made = maker_of(plan, *source);
        const PlannedNode& maker = plan.nodes[made.node];
        const std::string output = made.output == 0 ? "" : "." + maker.type->outputs[made.output].name;
        item.origin = {maker.id + output, description_of(maker, document)};
      }
    }
  }
}

}  // namespace dini

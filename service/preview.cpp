#include "service/preview.h"

#include <algorithm>

#include "gltf/encode_cost.h"
#include "gltf/glb_groups.h"
#include "graph/cost.h"
#include "graph/groups.h"
#include "graph/stopped.h"
#include "service/places.h"
#include "service/preview_parts.h"
#include "service/version.h"

namespace dini {

namespace {

/// Of all lines of all previews together.
constexpr std::size_t line_points = 1'000'000;
constexpr std::size_t most_line_points = 50'000;  ///< of one output

/// Adds the outputs that one entry names.
std::optional<Problem> read_entry(const Registry& registry, const Document& document, const std::string& entry,
                                  const std::string& pointer, PreviewNames& names) {
  const PlaceName place = place_name(entry);
  const auto& [id, output, has_output] = place;
  const auto node = document.nodes.find(id);
  if (node == document.nodes.end()) return unknown_node(document, place, pointer);
  std::set<std::size_t>& outputs = names[id];
  const NodeType* type = registry.find(node->second.type);
  if (type == nullptr) return std::nullopt;  // the check of the graph reports it
  if (!has_output) {
    for (std::size_t k = 0; k < (node->second.bypass ? 1 : type->outputs.size()); ++k) outputs.insert(k);
    return std::nullopt;
  }
  const OutputPort* port = type->find_output(output);
  if (port == nullptr) return unknown_output(*type, id, output, pointer);
  const std::size_t index = type->output_index(output);
  if (node->second.bypass && index > 0) return bypassed_output(id, output, pointer);
  outputs.insert(index);
  return std::nullopt;
}

/// The axis of a node's output along which its points make curves: one that a node before it made for curves.
std::optional<std::size_t> curve_axis(const Plan& plan, std::size_t node, const Axes& axes) {
  std::set<std::size_t> seen;
  std::vector<std::size_t> stack = {standing_at(plan, node)};
  std::set<std::string> curves;
  while (!stack.empty()) {
    const std::size_t at = stack.back();
    stack.pop_back();
    if (!seen.insert(at).second) continue;
    const PlannedNode& planned = plan.nodes[at];
    if (planned.type->makes_curves && !planned.made.empty()) {
      for (const Axis& axis : planned.made.front()) curves.insert(axis.name);
    }
    for (const PlannedInput& input : planned.inputs) {
      for (const PlannedItem& item : input.items) {
        if (const auto* source = std::get_if<Source>(&item.from)) stack.push_back(source->node);
      }
    }
  }
  for (std::size_t k = axes.size(); k-- > 0;) {
    if (curves.contains(axes[k].name)) return k;
  }
  return std::nullopt;
}

bool is_drawn(WireType type) { return type != WireType::number && type != WireType::asset && type != WireType::field; }

/// How many points all lines of one of so many outputs have at most.
std::size_t points_of_lines(std::size_t outputs) {
  return std::min(most_line_points, line_points / std::max<std::size_t>(1, outputs));
}

/// What is drawn of an output at most.
void add_drawn(const WireShape& shape, const Limits& limits, std::size_t points, DrawnSizes& drawn) {
  constexpr double points_of_element = 800;  // control geometry of a generator that is no simple motion
  const auto samples = static_cast<double>(sample_count(shape.axes));
  const double elements = std::min(samples, static_cast<double>(limits.preview_elements));
  if (shape.type == WireType::mesh) {
    drawn.meshes += elements;
    drawn.vertices += static_cast<double>(shape.vertices) * elements / std::max(1.0, samples);
  } else if (shape.type == WireType::point) {
    drawn.curves += elements;
    drawn.curve_points += std::min(samples, static_cast<double>(points));
  } else if (is_drawn(shape.type)) {
    drawn.curves += elements;
    drawn.curve_points += points_of_element * elements;
  }
}

PreviewedOutput previewed(const Plan& plan, const Evaluation& evaluation, std::size_t node, std::size_t output) {
  PreviewedOutput found{plan.nodes[node].type->outputs[output].name, evaluation.value(plan, node, output)};
  if (found.value.type() == WireType::point) found.curve_axis = curve_axis(plan, node, found.value.axes);
  return found;
}

Problem problem_of(const EncodeError& error) {
  const bool large = error.code == EncodeError::Code::too_large;
  return {.code = large ? "limit-exceeded" : "encode-failed",
          .detail = "the preview: " + error.detail,
          .node = error.part,
          .pointer = "/preview",
          .in_request = true};
}

}  // namespace

Result<PreviewNames> read_previews(const Registry& registry, const Document& document,
                                   const std::vector<std::string>& asked, const Limits& limits) {
  if (asked.size() > limits.previews) {
    return Problem{.code = "limit-exceeded",
                   .detail = "there are " + std::to_string(asked.size()) + " entries, at most " +
                             std::to_string(limits.previews) + " are accepted",
                   .pointer = "/preview",
                   .in_request = true};
  }
  PreviewNames names;
  Problems problems;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    for (const std::string& place : places_behind(document, asked[i])) {
      auto problem = read_entry(registry, document, place, "/preview/" + std::to_string(i), names);
      if (problem) problems.push_back(*std::move(problem));
    }
  }
  if (!problems.empty()) return problems;
  return names;
}

Result<std::vector<Preview>> plan_previews(Plan& plan, const PreviewNames& names, const Limits& limits) {
  std::vector<Preview> previews;
  std::size_t vertices = 0;
  for (const auto& [id, outputs] : names) {
    Preview& preview = previews.emplace_back(Preview{plan.index.at(id), {}});
    for (const std::size_t output : outputs) {
      const WireShape& shape = plan.nodes[preview.node].outputs[output];
      if (is_drawn(shape.type)) preview.outputs.push_back(output);
      if (shape.type == WireType::mesh) vertices += shape.vertices;
    }
  }
  if (vertices > limits.vertices) {
    return Problem{.code = "limit-exceeded",
                   .detail = "the previewed meshes would have " + std::to_string(vertices) +
                             " vertices together, at most " + std::to_string(limits.vertices) + " are accepted",
                   .pointer = "/preview",
                   .in_request = true};
  }
  std::size_t outputs = 0;
  for (const Preview& preview : previews) outputs += preview.outputs.size();
  DrawnSizes drawn;
  for (const Preview& preview : previews) {
    for (const std::size_t output : preview.outputs) {
      add_drawn(plan.nodes[preview.node].outputs[output], limits, points_of_lines(outputs), drawn);
    }
  }
  const EncodeCost cost = encode_cost(drawn, EncodeOptions().speed);
  constexpr double line_point_bytes = 128;  // as they are drawn, before they are written
  plan.cost.work += static_cast<std::size_t>(cost.work);
  plan.cost.bytes += static_cast<std::size_t>(cost.bytes + 2 * cost.file_bytes + line_point_bytes * drawn.curve_points);
  if (auto problem = over_limits(plan.cost, limits, "with these previews the request")) {
    problem->pointer = "/preview";
    problem->in_request = true;
    return *problem;
  }
  return previews;
}

Digest preview_digest(const Plan& plan, const std::vector<Preview>& previews, const Limits& limits) {
  DigestBuilder digest;
  digest.text("preview").text(engine_version).integer(limits.preview_elements).integer(limits.preview_points);
  for (const Preview& preview : previews) {
    const PlannedNode& node = plan.nodes[preview.node];
    digest.text(node.id).text(node.type->id).integer(preview.outputs.size());
    if (preview.outputs.empty()) continue;
    digest.digest(plan.nodes[standing_at(plan, preview.node)].fingerprint);
    if (node.bypass) digest.integer(std::get<Source>(node.bypass->from).output);
    for (const std::size_t output : preview.outputs) digest.integer(output);
  }
  return digest.finish();
}

Result<std::string> draw_previews(const Plan& plan, const Evaluation& evaluation, const std::vector<Preview>& previews,
                                  const EncodeOptions& options, const Limits& limits, const Cancel& cancel) {
  std::vector<std::vector<PreviewedOutput>> outputs;
  std::vector<Value> values;
  for (const Preview& preview : previews) {
    std::vector<PreviewedOutput>& of_node = outputs.emplace_back();
    for (const std::size_t output : preview.outputs) {
      of_node.push_back(previewed(plan, evaluation, preview.node, output));
      values.push_back(of_node.back().value);
    }
  }
  const PreviewFrame frame = frame_of(values, limits.preview_elements, cancel);
  const std::size_t points = points_of_lines(values.size());
  std::vector<GlbGroup> groups;
  for (std::size_t k = 0; k < previews.size(); ++k) {
    const PlannedNode& node = plan.nodes[previews[k].node];
    GlbGroup& group = groups.emplace_back(GlbGroup{node.id, {{"id", node.id}, {"type", node.type->id}}, {}});
    for (const PreviewedOutput& output : outputs[k]) {
      if (cancel.stopped()) break;
      for (GlbChild& child : drawn_parts(output, frame, limits, points, cancel))
        group.children.push_back(std::move(child));
    }
  }
  EncodeResult<std::string> encoded = encode_groups(groups, options, cancel);
  if (encoded) return *std::move(encoded);
  if (encoded.error().code == EncodeError::Code::canceled) return stopped_problem(cancel.reason());
  return problem_of(encoded.error());
}

}  // namespace dini

#include "graph/infer.h"

#include <algorithm>

#include "graph/kept_axes.h"
#include "graph/literal.h"

namespace dini {

namespace {

const Axis* find_axis(const Axes& axes, const std::string& name) {
  const auto found = std::find_if(axes.begin(), axes.end(), [&](const Axis& axis) { return axis.name == name; });
  return found == axes.end() ? nullptr : &*found;
}

std::string describe(const Axis& axis) { return std::to_string(axis.size) + (axis.closed ? " closed" : " open"); }

std::string names_of(const Axes& axes) {
  if (axes.empty()) return "no axes";
  std::string text = axes.size() == 1 ? "the axis" : "the axes";
  for (const Axis& axis : axes) text.append(" ").append(axis.name);
  return text;
}

class Inference {
 public:
  Inference(PlannedNode& node, const Limits& limits) : node_(node), limits_(limits) {}

  std::optional<Problem> run() {
    name_lists();
    for (std::size_t port = 0; port < node_.inputs.size(); ++port) {
      if (auto problem = join_items(port)) return problem;
    }
    if (auto problem = find_consumed()) return problem;
    if (auto problem = unite()) return problem;
    return make_outputs();
  }

 private:
  const std::string& port_name(std::size_t port) const { return node_.type->inputs[port].name; }
  const InputSlot& slot(std::size_t port) const { return node_.overload->inputs[port]; }

  Problem problem(std::string code, const std::string& port, std::string detail) const {
    return {std::move(code), std::move(detail), node_.id, port, ""};
  }

  /// Whether an input that takes several is given one value over no axes, which is a list of one.
  bool is_single(std::size_t port) const {
    const PlannedInput& input = node_.inputs[port];
    return node_.type->inputs[port].spec.takes_several && !input.list_axis && input.items.size() == 1 &&
           input.items.front().shape.axes.empty() && !slot(port).is_mixed();
  }

  /// The text at a port; empty where there is none.
  std::string text_literal(const std::string& port) const {
    const auto found = node_.literals.find(port);
    return found == node_.literals.end() ? "" : std::get<std::string>(found->second);
  }

  /// Lists of one node share an axis: the consumed one of a wired block, else the one that the card lets a text name,
  /// else one called as the node.
  void name_lists() {
    std::string name = text_literal(node_.type->list_axis);
    if (name.empty()) name = node_.id;
    const std::optional<std::size_t> block = node_.overload->first_block();
    if (block && is_single(*block)) node_.inputs[*block].list_axis = Axis{name, 1, false};
    const Axes* wired = nullptr;
    if (block && !node_.inputs[*block].list_axis && !node_.inputs[*block].items.empty()) {
      wired = &node_.inputs[*block].items.front().shape.axes;
      const std::string over = text_literal(node_.type->over.front());
      if (!over.empty()) {
        name = over;
      } else if (!wired->empty()) {
        name = wired->back().name;
      }
    }
    for (PlannedInput& input : node_.inputs) {
      if (!input.list_axis) continue;
      input.list_axis->name = name;
      const Axis* paired = wired == nullptr ? nullptr : find_axis(*wired, name);
      if (paired != nullptr) input.list_axis->closed = paired->closed;
    }
  }

  std::optional<Problem> add_axes(Axes& axes, const Axes& more, const std::string& port,
                                  const std::string& other) const {
    for (const Axis& axis : more) {
      const Axis* known = find_axis(axes, axis.name);
      if (known == nullptr) {
        axes.push_back(axis);
      } else if (known->size != axis.size || known->closed != axis.closed) {
        return problem("axis-mismatch", port,
                       "axis " + axis.name + " is " + describe(axis) + " at " + port + " but " + describe(*known) +
                           " at " + other +
                           "; the same name must have the same size and closure, different axes different names");
      }
    }
    return std::nullopt;
  }

  /// The shape of an input from its items.
  std::optional<Problem> join_items(std::size_t port) const {
    PlannedInput& input = node_.inputs[port];
    if (input.items.empty()) return std::nullopt;
    input.shape = input.items.front().shape;
    if (slot(port).is_mixed()) {
      input.shape.axes.clear();
      input.shape.vertices = input.shape.most_vertices = 0;
      for (const PlannedItem& item : input.items) {
        input.shape.vertices += item.shape.vertices;
        input.shape.most_vertices += item.shape.most_vertices;
      }
      return std::nullopt;
    }
    if (!input.list_axis) return std::nullopt;
    for (const PlannedItem& item : input.items) {
      if (auto found = add_axes(input.shape.axes, item.shape.axes, port_name(port), port_name(port))) return found;
    }
    return add_axes(input.shape.axes, {*input.list_axis}, port_name(port), port_name(port));
  }

  std::optional<Problem> find_consumed() {
    const std::size_t wanted = node_.overload->consumed_axes();
    if (wanted == 0) return std::nullopt;
    const std::size_t block = *node_.overload->first_block();
    if (node_.inputs[block].items.empty()) return std::nullopt;  // it may be left out
    const Axes& axes = node_.inputs[block].shape.axes;
    if (axes.size() < wanted && !slot(block).optional) {
      return problem("axis-mismatch", port_name(block),
                     port_name(block) + " needs " + std::to_string(wanted) + (wanted == 1 ? " axis" : " axes") +
                         ", it has " + names_of(axes));
    }
    for (const std::string& name : consumed_names(wanted, axes)) {
      const std::string& over = node_.type->over[node_.consumed.size()];
      const Axis* axis = find_axis(axes, name);
      if (axis == nullptr && !name.empty()) {
        return problem("axis-mismatch", over,
                       "there is no axis " + excerpt(name) + " at " + port_name(block) + ", it has " + names_of(axes));
      }
      if (axis != nullptr && find_axis(node_.consumed, name) != nullptr) {
        return problem("axis-mismatch", over, "the axis " + name + " is named twice");
      }
      node_.consumed.push_back(axis != nullptr ? *axis : Axis{});
    }
    return std::nullopt;
  }

  /// Which of these axes are consumed, in order. Those that texts do not name are the last ones that are left; a name
  /// is empty where there are too few.
  std::vector<std::string> consumed_names(std::size_t wanted, const Axes& axes) const {
    std::vector<std::string> names;
    std::vector<std::size_t> unnamed;
    for (std::size_t k = 0; k < wanted; ++k) {
      names.push_back(text_literal(node_.type->over[k]));
      if (names.back().empty()) unnamed.push_back(k);
    }
    std::vector<std::string> left;
    for (const Axis& axis : axes) {
      if (std::find(names.begin(), names.end(), axis.name) == names.end()) left.push_back(axis.name);
    }
    unnamed.resize(std::min(unnamed.size(), left.size()));
    for (std::size_t k = 0; k < unnamed.size(); ++k) names[unnamed[k]] = left[left.size() - unnamed.size() + k];
    return names;
  }

  /// The lifted axes: all axes of all inputs, less the consumed ones.
  std::optional<Problem> unite() {
    Axes all;
    std::map<std::string, std::string> from;
    for (std::size_t port = 0; port < node_.inputs.size(); ++port) {
      for (const Axis& axis : node_.inputs[port].shape.axes) {
        const std::string& other = from.emplace(axis.name, port_name(port)).first->second;
        if (auto found = add_axes(all, {axis}, port_name(port), other)) return found;
      }
    }
    for (const Axis& axis : all) {
      if (find_axis(node_.consumed, axis.name) == nullptr) {
        node_.lifted.push_back(axis);
      } else if (!only_blocks_have(axis.name)) {
        return problem("axis-mismatch", from[axis.name],
                       "the axis " + axis.name + " is used up by " + port_name(*node_.overload->first_block()) +
                           ", so no other input of this node may run over it");
      }
    }
    return std::nullopt;
  }

  bool only_blocks_have(const std::string& axis) const {
    for (std::size_t port = 0; port < node_.inputs.size(); ++port) {
      if (!slot(port).is_block() && find_axis(node_.inputs[port].shape.axes, axis) != nullptr) return false;
    }
    return true;
  }

  /// Of one mesh made: by the rule, or by what is given.
  std::size_t vertices_per_run(const VertexRule& rule, std::size_t WireShape::*given) const {
    if (rule) return rule(node_.literals, node_.consumed);
    const std::size_t factor = node_.type->vertex_factor ? node_.type->vertex_factor(node_.literals) : 1;
    return factor * given_per_run(given);
  }

  /// The most that one mesh made has.
  std::size_t most_vertices_per_run() const {
    const NodeType& type = *node_.type;
    if (type.most_of_given) return type.most_of_given(node_.literals, given_per_run(&WireShape::most_vertices));
    return vertices_per_run(type.most_vertices ? type.most_vertices : type.vertices, &WireShape::most_vertices);
  }

  /// Of the meshes that one run is given, together.
  std::size_t given_per_run(std::size_t WireShape::*given) const {
    std::size_t total = 0;
    for (std::size_t port = 0; port < node_.inputs.size(); ++port) {
      const PlannedInput& input = node_.inputs[port];
      const std::size_t meshes = slot(port).is_mixed() ? 1 : std::max<std::size_t>(1, sample_count(input.shape.axes));
      total += input.shape.*given / meshes;
    }
    return total;
  }

  /// The last port that gives an axis this name.
  std::string naming_port(const std::string& axis) const {
    std::string found;
    for (const InputPort& port : node_.type->inputs) {
      const auto& over = node_.type->over;
      if (!port.spec.is_axis_name || std::find(over.begin(), over.end(), port.name) != over.end()) continue;
      const std::string text = text_literal(port.name);
      if (text == axis || (text.empty() && axis == node_.id)) found = port.name;
    }
    return found;
  }

  std::optional<Problem> make_outputs() {
    const Overload& overload = *node_.overload;
    node_.made.assign(overload.outputs.size(), {});
    if (node_.type->axes) {
      std::vector<Axes> made = node_.type->axes(node_.literals, node_.id);
      made.resize(overload.outputs.size());
      for (std::size_t output = 0; output < overload.outputs.size(); ++output) {
        if (!overload.outputs[output].makes_axes) continue;
        for (const Axis& axis : made[output]) {
          if (is_kept_axes(axis)) {
            node_.made[output].insert(node_.made[output].end(), node_.consumed.begin(), node_.consumed.end());
          } else {
            node_.made[output].push_back(axis);
          }
        }
      }
    }
    for (std::size_t output = 0; output < overload.outputs.size(); ++output) {
      WireShape shape{overload.outputs[output].type, node_.lifted};
      for (const Axis& axis : node_.made[output]) {
        if (find_axis(node_.lifted, axis.name) != nullptr) {
          return problem(
              "axis-mismatch", naming_port(axis.name),
              "this node makes the axis " + axis.name + ", which its inputs have already; give it another name");
        }
        if (find_axis(shape.axes, axis.name) != nullptr) {
          return problem("axis-mismatch", naming_port(axis.name),
                         "this node makes two axes called " + axis.name + "; give one of them another name");
        }
        shape.axes.push_back(axis);
      }
      const std::size_t samples = sample_count(shape.axes);
      if (samples > limits_.samples) return too_many("values", samples, limits_.samples);
      if (shape.type == WireType::mesh || shape.type == WireType::asset) {
        const NodeType& type = *node_.type;
        const std::size_t each = vertices_per_run(type.vertices, &WireShape::vertices);
        if (samples > 0 && each > limits_.vertices / samples) {
          return too_many("vertices", each > limits_.vertices ? each : each * samples, limits_.vertices);
        }
        shape.vertices = each * samples;
        // A closed grid has two for each vertex.
        if (shape.vertices > limits_.triangles / 2) return too_many("triangles", 2 * shape.vertices, limits_.triangles);
        shape.most_vertices = samples * most_vertices_per_run();
      }
      node_.outputs.push_back(std::move(shape));
    }
    return std::nullopt;
  }

  Problem too_many(const char* what, std::size_t count, std::size_t limit) const {
    return problem("limit-exceeded", "",
                   "this node would make " + std::to_string(count) + " " + what + ", at most " + std::to_string(limit) +
                       " are accepted");
  }

  PlannedNode& node_;
  const Limits& limits_;
};

}  // namespace

std::optional<Problem> infer_axes(PlannedNode& node, const Limits& limits) { return Inference(node, limits).run(); }

}  // namespace dini

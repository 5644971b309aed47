#include "graph/registry.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "graph/literal.h"
#include "graph/node_builder.h"

namespace dini {

namespace {

[[noreturn]] void refuse(const NodeType& type, const std::string& why) {
  throw std::logic_error("node type \"" + type.id + "\": " + why);
}

void add_type(std::vector<WireType>& types, WireType type) {
  if (std::find(types.begin(), types.end(), type) == types.end()) types.push_back(type);
}

/// Fills in what the functions' signatures say about the ports.
void complete_ports(NodeType& type) {
  for (std::size_t port = 0; port < type.inputs.size(); ++port) {
    InputPort& input = type.inputs[port];
    for (const Overload& overload : type.overloads) {
      const InputSlot& slot = overload.inputs[port];
      for (const WireType mixed : slot.mixed) add_type(input.types, mixed);
      if (!slot.is_mixed()) add_type(input.types, slot.type);
      input.optional = slot.optional;
      input.names_file = slot.file;
      input.choices = slot.words;
      input.keeps_apart = slot.is_mixed();
    }
  }
  for (std::size_t port = 0; port < type.outputs.size(); ++port) {
    for (const Overload& overload : type.overloads) add_type(type.outputs[port].types, overload.outputs[port].type);
  }
}

/// Reads its default as well.
void check_input(const NodeType& type, InputPort& input) {
  if (input.name.empty() || input.doc.empty()) refuse(type, "an input lacks its name or its text");
  const InputSpec& spec = input.spec;
  if (spec.minimum && spec.soft_minimum && *spec.soft_minimum < *spec.minimum)
    refuse(type, input.name + ": soft range");
  if (spec.maximum && spec.soft_maximum && *spec.soft_maximum > *spec.maximum)
    refuse(type, input.name + ": soft range");
  if (spec.default_value.is_null()) return;
  input.usual = read_literal(spec.default_value, input);
  if (!input.usual.as(input.types.front())) refuse(type, input.name + ": default outside its own range");
}

/// A handle turns a drag into a literal, so it can only set points, vectors and numbers, and stands at inputs that are
/// places.
void check_handle(const NodeType& type, const InputPort& input) {
  if (!input.spec.handle) return;
  const auto takes = [](const InputPort* port, WireType wanted) {
    return port != nullptr && std::find(port->types.begin(), port->types.end(), wanted) != port->types.end();
  };
  const auto& [kind, at, normal] = *input.spec.handle;
  const WireType set = kind == Handle::Kind::position    ? WireType::point
                       : kind == Handle::Kind::direction ? WireType::vector
                                                         : WireType::number;
  if (!takes(&input, set)) refuse(type, input.name + ": its handle sets another type");
  if (!at.empty() && !takes(type.find_input(at), WireType::point))
    refuse(type, input.name + ": its handle sits nowhere");
  if (!normal.empty() && !takes(type.find_input(normal), WireType::vector)) {
    refuse(type, input.name + ": the plane of its handle has no normal");
  }
}

template <class Ports>
void check_names(const NodeType& type, const Ports& ports) {
  std::set<std::string> names;
  for (const auto& port : ports) {
    if (!names.insert(port.name).second) refuse(type, "two ports are called " + port.name);
  }
}

}  // namespace

void Registry::add(NodeType type) {
  if (type.title.empty() || type.family.empty() || type.doc.empty()) refuse(type, "title, family or doc is missing");
  for (const Overload& overload : type.overloads) {
    if (overload.outputs.size() != type.outputs.size()) refuse(type, "the card does not describe every output");
    if (overload.consumed_axes() > type.over.size()) refuse(type, "a consumed axis has no input to name it");
    const bool makes = std::any_of(overload.outputs.begin(), overload.outputs.end(),
                                   [](const OutputSlot& output) { return output.makes_axes; });
    if (makes != static_cast<bool>(type.axes)) refuse(type, "made axes and the axis rule do not agree");
  }
  complete_ports(type);
  check_names(type, type.inputs);
  check_names(type, type.outputs);
  for (InputPort& input : type.inputs) {
    check_input(type, input);
    check_handle(type, input);
  }
  if (!type.list_axis.empty() && type.find_input(type.list_axis) == nullptr) {
    refuse(type, "no input names the axis of lists " + type.list_axis);
  }
  const std::string id = type.id;
  if (!types_.emplace(id, std::move(type)).second) throw std::logic_error("node type \"" + id + "\" is declared twice");
}

const NodeType* Registry::find(std::string_view id) const {
  const auto found = types_.find(id);
  return found == types_.end() ? nullptr : &found->second;
}

namespace {

std::string axis_name(const Literals& literals, const std::string& port, const std::string& node_id) {
  const std::string& given = text_at(literals, port);
  return given.empty() ? node_id : given;
}

}  // namespace

AxisRule one_axis(std::string count, std::string axis, std::string closed, std::size_t outputs) {
  return [count = std::move(count), axis = std::move(axis), closed = std::move(closed), outputs](
             const Literals& literals, const std::string& node_id) {
    const auto size = static_cast<std::size_t>(integer_at(literals, count));
    const Axis made{axis_name(literals, axis, node_id), size, !closed.empty() && boolean_at(literals, closed)};
    return std::vector<Axes>(outputs, Axes{made});
  };
}

}  // namespace dini

#include "graph/resolve.h"

#include <algorithm>

#include "graph/fixes.h"
#include "graph/literal.h"

namespace dini {

namespace {

/// Something given to an input, before its type is settled: a wire, a literal of the document or the default of the
/// card, or a parameter. `item` is its place in the list of its input; a default has none.
struct Given {
  std::optional<PlannedItem> wire = {};
  const Json* written = nullptr;
  const Readings* readings = nullptr;
  const std::pair<const std::string, Parameter>* parameter = nullptr;
  std::optional<std::size_t> item = {};
};

std::string names_of(const std::vector<WireType>& types) {
  std::string text;
  for (const WireType type : types) text += (text.empty() ? "" : " or ") + std::string(name(type));
  return text;
}

bool parameter_fits(WireType parameter, WireType port) {
  if (parameter == port) return true;
  switch (parameter) {
    case WireType::integer:
      return port == WireType::number;
    case WireType::vector:
      return port == WireType::point;
    case WireType::choice:
      return port == WireType::text;
    default:
      return false;
  }
}

class Resolver {
 public:
  Resolver(const std::string& id, const NodeEntry& entry, const NodeType& type, const Document& document,
           const Plan& plan, const AssetFinder& find_asset)
      : id_(id), entry_(entry), type_(type), document_(document), plan_(plan), find_asset_(find_asset) {}

  Resolved run() {
    gather();
    Resolved best;
    if (entry_.bypass) {
      pass_on(best);
      return best;
    }
    // Where wires fit, most often nothing is wrong, and of the others no problem has to be written.
    for (const Overload& overload : type_.overloads) {
      if (!wires_fit(overload)) continue;
      best = read_as(overload);
      if (best.problems.empty()) return best;
    }
    // The overload with the fewest problems is the one that was meant; the first one on a tie.
    for (std::size_t k = 0; k < type_.overloads.size(); ++k) {
      Resolved candidate = read_as(type_.overloads[k]);
      if (k == 0 || candidate.problems.count() < best.problems.count()) best = std::move(candidate);
      if (best.problems.empty()) break;
    }
    return best;
  }

 private:
  /// What makes a problem of a port, when it is to be listed.
  template <class Make>
  void add(Resolved& resolved, const std::string& port, Make make) const {
    resolved.first_input_is_wrong = resolved.first_input_is_wrong || port == type_.inputs.front().name;
    resolved.problems.add(make);
  }

  Problem problem(std::string code, const std::string& port, std::string detail, Json fix = nullptr) const {
    return {std::move(code), std::move(detail), id_, port, input_pointer(id_, port), std::move(fix)};
  }

  void gather() {
    given_.resize(type_.inputs.size());
    listed_.resize(type_.inputs.size());
    for (std::size_t port = 0; port < type_.inputs.size(); ++port) {
      const auto entry = entry_.inputs.find(type_.inputs[port].name);
      if (entry == entry_.inputs.end()) continue;
      const InputEntry& input = entry->second;
      listed_[port] = input.list;
      for (const InputItem& item : input.items) {
        given_[port].push_back(look_up(item, port));
        given_[port].back().item = given_[port].size() - 1;
      }
    }
  }

  Given look_up(const InputItem& item, std::size_t port) {
    if (const auto* link = std::get_if<Link>(&item)) return {.wire = wire(*link, type_.inputs[port].name)};
    if (const auto* reference = std::get_if<ParameterReference>(&item)) {
      return {.written = &plan_.parameters.at(reference->name).written,
              .parameter = &*document_.parameters.find(reference->name)};
    }
    const auto& literal = std::get<WrittenLiteral>(item);
    return {.written = &literal.written, .readings = &literal.readings};
  }

  PlannedItem wire(const Link& link, const std::string& port) {
    const std::size_t index = plan_.index.at(link.node);
    const PlannedNode& source = plan_.nodes[index];
    std::size_t output = 0;
    if (!link.output.empty()) {
      output = source.type->output_index(link.output);
    }
    if (!source.bypass) return {Source{index, output}, source.outputs[output]};
    if (output > 0) {
      early_.add(problem("dangling-link", port,
                         "node " + link.node + " is bypassed and passes on its first input only, as output " +
                             source.type->outputs.front().name));
    }
    return *source.bypass;
  }

  /// A bypassed node passes its first input on, whatever else is given to it.
  void pass_on(Resolved& resolved) {
    resolved.node.id = id_;
    resolved.node.type = &type_;
    resolved.problems = early_;
    const std::string& port = type_.inputs.empty() ? id_ : type_.inputs.front().name;
    if (given_.empty() || given_.front().empty() || !given_.front().front().wire) {
      resolved.problems.add(problem("required-input-missing", port, "a bypassed node needs a link at its first input"));
      return;
    }
    resolved.node.bypass = given_.front().front().wire;
    resolved.node.outputs = {resolved.node.bypass->shape};
  }

  Resolved read_as(const Overload& overload) const {
    Resolved resolved;
    resolved.problems = early_;
    PlannedNode& node = resolved.node;
    node.id = id_;
    node.type = &type_;
    node.overload = &overload;
    node.inputs.resize(type_.inputs.size());
    for (std::size_t port = 0; port < type_.inputs.size(); ++port) read_port(overload, port, resolved);
    check_list_sizes(resolved);
    return resolved;
  }

  void read_port(const Overload& overload, std::size_t port, Resolved& resolved) const {
    const InputPort& card = type_.inputs[port];
    PlannedInput& input = resolved.node.inputs[port];
    const std::vector<Given>& given = given_[port];
    if (given.empty()) {
      use_default(overload, port, resolved);
      return;
    }
    if (listed_[port] && !card.spec.takes_several) {
      add(resolved, card.name, [&] {
        return problem("type-mismatch", card.name,
                       card.name + " takes one value, got a list of " + std::to_string(given.size()));
      });
      return;
    }
    for (const Given& item : given) {
      if (item.wire) {
        read_wire(overload, port, *item.wire, resolved);
      } else {
        take_literal(overload, port, item, resolved);
      }
    }
    if (listed_[port] && !overload.inputs[port].is_mixed()) input.list_axis = Axis{"", given.size(), false};
  }

  void use_default(const Overload& overload, std::size_t port, Resolved& resolved) const {
    const InputPort& card = type_.inputs[port];
    if (card.required()) {
      add(resolved, card.name, [&] {
        Json fix = missing_input(id_, entry_, card);
        const std::string more = card.spec.takes_several && listed_[port] ? "; the list is empty" : "";
        return problem(
            "required-input-missing", card.name,
            card.name + " is missing: " + (fix.is_null() ? "connect a " : "it takes a ") + names_of(card.types) + more,
            std::move(fix));
      });
      return;
    }
    if (card.optional) return;
    take_literal(overload, port, {.written = &card.spec.default_value, .readings = &card.usual}, resolved);
  }

  /// Whether a wire of this type is what an input takes.
  bool takes(const Overload& overload, std::size_t port, WireType type) const {
    const InputSlot& slot = overload.inputs[port];
    return slot.is_mixed() ? std::ranges::find(type_.inputs[port].types, type) != type_.inputs[port].types.end()
                           : type == slot.type;
  }

  bool wires_fit(const Overload& overload) const {
    for (std::size_t port = 0; port < given_.size(); ++port) {
      for (const Given& item : given_[port]) {
        if (item.wire && !takes(overload, port, item.wire->shape.type)) return false;
      }
    }
    return true;
  }

  void read_wire(const Overload& overload, std::size_t port, const PlannedItem& item, Resolved& resolved) const {
    const InputPort& card = type_.inputs[port];
    const WireType wanted = overload.inputs[port].type;
    const WireType type = item.shape.type;
    const bool literal_only = !overload.inputs[port].is_mixed() && info(wanted).literal_only;
    const bool fits = takes(overload, port, type);
    if (literal_only) {
      add(resolved, card.name, [&] {
        return problem("type-mismatch", card.name,
                       card.name + " is written in the graph or given as a parameter (" + std::string(name(wanted)) +
                           "); it takes no link");
      });
    } else if (!fits) {
      add(resolved, card.name, [&] {
        return problem("type-mismatch", card.name,
                       card.name + " takes " + names_of(card.types) + ", got a link to a " + std::string(name(type)));
      });
    } else {
      resolved.node.inputs[port].items.push_back(item);
    }
  }

  /// What is given means at this function, or why it means nothing there.
  LiteralResult reading_of(const Overload& overload, std::size_t port, const Given& given) const {
    const InputPort& card = type_.inputs[port];
    const InputSlot& slot = overload.inputs[port];
    if (slot.is_mixed()) return LiteralProblem{"type-mismatch", "expected a link to a " + names_of(card.types)};
    if (given.parameter == nullptr) return given.readings->as(slot.type);
    return given_to(card, slot.type, plan_.parameters.at(given.parameter->first));
  }

  void take_literal(const Overload& overload, std::size_t port, const Given& given, Resolved& resolved) const {
    const InputPort& card = type_.inputs[port];
    const WireType wanted = overload.inputs[port].type;
    if (given.parameter != nullptr && !parameter_fits(given.parameter->second.type, wanted)) {
      add(resolved, card.name, [&] {
        return problem("type-mismatch", card.name,
                       card.name + " takes " + names_of(card.types) + ", got the parameter " + given.parameter->first +
                           " of type " + std::string(name(given.parameter->second.type)));
      });
      return;
    }
    LiteralResult read = reading_of(overload, port, given);
    if (!read) {
      const LiteralProblem& wrong = read.error();
      add(resolved, card.name, [&] {
        const bool written_here = given.parameter == nullptr && given.item;
        return problem(
            wrong.code, card.name, card.name + driver_text(given) + ": " + wrong.detail,
            written_here ? acceptable_literal(place_of(port, *given.item), wrong.code, *given.written, card) : Json());
      });
      stand_in(port, wanted, resolved);
      return;
    }
    Argument& argument = *read;
    if (card.names_file) {
      const std::string& text = std::get<std::string>(std::get<Literal>(argument));
      SharedAssetFile file = find_asset_ ? find_asset_(text) : nullptr;
      if (file == nullptr) {
        add(resolved, card.name, [&] {
          return problem("unknown-asset", card.name,
                         card.name + ": there is no file " + excerpt(text) +
                             " here; upload it to /v1/assets, or give it with --asset");
        });
        return;
      }
      argument = Literal(std::move(file));
    }
    PlannedInput& input = resolved.node.inputs[port];
    if (given.parameter != nullptr) input.parameters.insert(given.parameter->first);
    if (const auto* literal = std::get_if<Literal>(&argument)) resolved.node.literals[card.name] = *literal;
    input.items.push_back({std::move(argument), {wanted, {}, 0}});
  }

  std::string place_of(std::size_t port, std::size_t item) const {
    return input_pointer(id_, type_.inputs[port].name) + (listed_[port] ? "/" + std::to_string(item) : "");
  }

  /// The default in place of a literal that was refused, so that types and axes of the outputs can still be told.
  void stand_in(std::size_t port, WireType wanted, Resolved& resolved) const {
    const InputPort& card = type_.inputs[port];
    if (card.spec.default_value.is_null() || card.names_file || resolved.node.literals.contains(card.name)) return;
    LiteralResult argument = card.usual.as(wanted);
    if (!argument) return;
    if (const auto* literal = std::get_if<Literal>(&*argument)) resolved.node.literals[card.name] = *literal;
    resolved.node.inputs[port].items.push_back({*std::move(argument), {wanted, {}, 0}});
  }

  /// ", given by the parameter reach (Reach)" for what a parameter drives.
  static std::string driver_text(const Given& given) {
    if (given.parameter == nullptr) return "";
    const auto& [name, known] = *given.parameter;
    return ", given by the parameter " + name + (known.label ? " (" + *known.label + ")" : "");
  }

  void check_list_sizes(Resolved& resolved) const {
    const std::vector<PlannedInput>& inputs = resolved.node.inputs;
    std::optional<std::size_t> first;
    for (std::size_t index = 0; index < inputs.size(); ++index) {
      const PlannedInput& input = inputs[index];
      if (!input.list_axis) continue;
      if (!first) first = index;
      const Axis& axis = *inputs[*first].list_axis;
      if (input.list_axis->size == axis.size) continue;
      const std::string& port = type_.inputs[index].name;
      const std::string& other = type_.inputs[*first].name;
      add(resolved, port, [&] {
        return problem("axis-mismatch", port,
                       port + " lists " + std::to_string(input.list_axis->size) + " items but " + other + " lists " +
                           std::to_string(axis.size) + "; lists of one node pair up");
      });
    }
  }

  const std::string& id_;
  const NodeEntry& entry_;
  const NodeType& type_;
  const Document& document_;
  const Plan& plan_;
  const AssetFinder& find_asset_;
  std::vector<std::vector<Given>> given_;
  std::vector<bool> listed_;
  ProblemCollector early_;
};

}  // namespace

Resolved resolve_node(const std::string& id, const NodeEntry& entry, const NodeType& type, const Document& document,
                      const Plan& plan, const AssetFinder& find_asset) {
  return Resolver(id, entry, type, document, plan, find_asset).run();
}

}  // namespace dini

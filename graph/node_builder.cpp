#include "graph/node_builder.h"

#include <stdexcept>

namespace dini {

namespace {

[[noreturn]] void refuse(const NodeType& type, const std::string& why) {
  throw std::logic_error("node type \"" + type.id + "\": " + why);
}

}  // namespace

void Declaration::add_port(std::string name, std::string doc, InputSpec spec) {
  type.inputs.push_back({std::move(name), std::move(doc), std::move(spec)});
}

void Declaration::add_first(std::string name, std::string doc, InputSpec spec) {
  if (!type.inputs.empty()) refuse(type, name + " is not the first input, so it goes to a member");
  add_port(std::move(name), std::move(doc), std::move(spec));
  for (std::size_t k = 0; k < functions.size(); ++k) {
    if (!functions[k].first) refuse(type, "a function takes no value by itself");
    type.overloads[k].inputs.push_back(*functions[k].first);
    type.overloads[k].bindings.push_back({0, functions[k].read_first, nullptr});
  }
}

void Declaration::add_card_text(std::string name, std::string doc, InputSpec spec) {
  add_port(std::move(name), std::move(doc), std::move(spec));
  for (Overload& overload : type.overloads) overload.inputs.push_back({WireType::text});
}

void Declaration::bind(std::size_t function, InputSlot slot, MakeReader reader, std::function<void*(void*)> member) {
  Function& taken = functions[function];
  ++taken.bound;
  taken.places.insert(member(taken.sample.get()));
  Overload& overload = type.overloads[function];
  overload.bindings.push_back({overload.inputs.size(), reader, std::move(member)});
  overload.inputs.push_back(std::move(slot));
}

NodeType Declaration::finish() && {
  for (std::size_t k = 0; k < functions.size(); ++k) {
    const Function& taken = functions[k];
    type.overloads[k].number = k;
    std::size_t members = 1;  // a base counts as a member and has some itself
    for (const auto& [structure, fields] : taken.structs) members += fields - 1;
    if (taken.structs.empty()) members = 0;
    const bool lacks_first =
        taken.first && (type.overloads[k].bindings.empty() || type.overloads[k].bindings[0].member);
    if (lacks_first) refuse(type, "the card does not describe the value that a function takes by itself");
    if (taken.bound != members) {
      refuse(type, "the card describes " + std::to_string(taken.bound) + " of the " + std::to_string(members) +
                       " members of a function's inputs");
    }
    if (taken.places.size() != taken.bound) refuse(type, "two inputs go to one member");
  }
  return std::move(type);
}

}  // namespace dini

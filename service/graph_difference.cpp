#include "service/graph_difference.h"

#include <string>

namespace dini {

namespace {

const Json& nothing() {
  static const Json object = Json::object();
  return object;
}

/// A member that is an object, or none.
const Json& object_at(const Json& holder, const char* name) {
  const auto found = holder.is_object() ? holder.find(name) : holder.end();
  return found != holder.end() && found->is_object() ? *found : nothing();
}

Json change(const Json* from, const Json* to) {
  Json changed = Json::object();
  if (from != nullptr) changed["from"] = *from;
  if (to != nullptr) changed["to"] = *to;
  return changed;
}

/// Every member that is not the same in both.
Json member_changes(const Json& before, const Json& after) {
  Json changes = Json::object();
  for (const auto& [name, value] : before.items()) {
    const auto now = after.find(name);
    if (now == after.end()) {
      changes[name] = change(&value, nullptr);
    } else if (*now != value) {
      changes[name] = change(&value, &*now);
    }
  }
  for (const auto& [name, value] : after.items()) {
    if (!before.contains(name)) changes[name] = change(nullptr, &value);
  }
  return changes;
}

bool is_bypassed(const Json& node) { return node.value("bypass", Json(false)) == true; }

Json node_changes(const Json& was, const Json& is) {
  const Json &before = was.is_object() ? was : nothing(), &after = is.is_object() ? is : nothing();
  Json changes = Json::object();
  if (const Json type =
          member_changes({{"type", before.value("type", Json())}}, {{"type", after.value("type", Json())}});
      !type.empty()) {
    changes["type"] = type["type"];
  }
  if (is_bypassed(before) != is_bypassed(after)) {
    changes["bypass"] = {{"from", is_bypassed(before)}, {"to", is_bypassed(after)}};
  }
  Json inputs = member_changes(object_at(before, "inputs"), object_at(after, "inputs"));
  if (!inputs.empty()) changes["inputs"] = std::move(inputs);
  return changes;
}

/// Names that came and went, and what `changes` says of those that stayed.
template <class Changes>
Json differences(const Json& before, const Json& after, Changes changes) {
  Json added = Json::array(), removed = Json::array(), changed = Json::object();
  for (const auto& [name, value] : before.items()) {
    const auto now = after.find(name);
    if (now == after.end()) {
      removed.push_back(name);
    } else if (Json found = changes(value, *now); !found.empty()) {
      changed[name] = std::move(found);
    }
  }
  for (const auto& [name, value] : after.items()) {
    if (!before.contains(name)) added.push_back(name);
  }
  return {{"added", std::move(added)}, {"removed", std::move(removed)}, {"changed", std::move(changed)}};
}

bool is_empty(const Json& found) {
  return found["added"].empty() && found["removed"].empty() && found["changed"].empty();
}

Json without_nodes(const Json& group) {
  Json rest = group.is_object() ? group : nothing();
  rest.erase("nodes");
  return rest;
}

Json group_changes(const Json& before, const Json& after) {
  Json changes = member_changes(without_nodes(before), without_nodes(after));
  Json nodes = differences(object_at(before, "nodes"), object_at(after, "nodes"), node_changes);
  if (!is_empty(nodes)) changes["nodes"] = std::move(nodes);
  return changes;
}

}  // namespace

Json graph_difference(const Json& before, const Json& after) {
  Json found = {
      {"nodes", differences(object_at(before, "nodes"), object_at(after, "nodes"), node_changes)},
      {"parameters", differences(object_at(before, "parameters"), object_at(after, "parameters"), member_changes)}};
  const Json &groups = object_at(before, "groups"), &groups_after = object_at(after, "groups");
  if (!groups.empty() || !groups_after.empty()) found["groups"] = differences(groups, groups_after, group_changes);
  return found;
}

}  // namespace dini

#include "graph/fixes.h"

#include <algorithm>
#include <cmath>

#include "graph/json_reader.h"
#include "graph/nearest.h"

namespace dini {

namespace {

/// `value` moved into a hard range; null when there is nothing in it.
Json clamped(const Json& value, const InputSpec& spec) {
  if (spec.minimum && spec.maximum && *spec.minimum > *spec.maximum) return nullptr;
  double inside = value.get<double>();
  if (spec.minimum) inside = std::max(inside, *spec.minimum);
  if (spec.maximum) inside = std::min(inside, *spec.maximum);
  if (!std::isfinite(inside)) return nullptr;
  if (value.is_number_integer()) return static_cast<std::int64_t>(inside);
  return inside;
}

Json neutral_literal(const InputPort& port) {
  const auto written_only = [](WireType type) {
    return type == WireType::number || type == WireType::integer || type == WireType::vector || type == WireType::point;
  };
  // Where links are taken too, a shape is meant, and no literal is a likely one.
  if (!std::all_of(port.types.begin(), port.types.end(), written_only)) return nullptr;
  switch (port.types.front()) {
    case WireType::number:
    case WireType::integer:
      return clamped(Json(0), port.spec);
    case WireType::vector:
      return {0, 0, 1};
    default:
      return {0, 0, 0};
  }
}

Json removal(const std::string& pointer) { return {{{"op", "remove"}, {"path", pointer}}}; }

}  // namespace

std::string input_pointer(const std::string& node, const std::string& port) {
  return "/nodes/" + pointer_token(node) + (port.empty() ? "" : "/inputs/" + pointer_token(port));
}

std::string item_pointer(const std::string& node, const std::string& port, const InputEntry& entry, std::size_t item) {
  return input_pointer(node, port) + (entry.list ? "/" + std::to_string(item) : "");
}

Json replacement(const std::string& pointer, Json value) {
  return {{{"op", "replace"}, {"path", pointer}, {"value", std::move(value)}}};
}

Json item_removal(const std::string& node, const std::string& port, const InputEntry& entry, std::size_t item) {
  return removal(entry.items.size() > 1 ? item_pointer(node, port, entry, item) : input_pointer(node, port));
}

Json missing_input(const std::string& node, const NodeEntry& entry, const InputPort& port) {
  Json literal = neutral_literal(port);
  if (literal.is_null()) return nullptr;
  if (port.spec.takes_several) literal = Json::array({std::move(literal)});
  // A node without inputs may lack the member that holds them.
  if (entry.inputs.empty()) {
    return {
        {{"op", "add"}, {"path", input_pointer(node, "") + "/inputs"}, {"value", {{port.name, std::move(literal)}}}}};
  }
  return {{{"op", "add"}, {"path", input_pointer(node, port.name)}, {"value", std::move(literal)}}};
}

Json acceptable_literal(const std::string& pointer, const std::string& code, const Json& given, const InputPort& port) {
  if (code == "out-of-range" && given.is_number()) {
    Json inside = clamped(given, port.spec);
    return inside.is_null() ? inside : replacement(pointer, std::move(inside));
  }
  if (code == "not-in-choices" && given.is_string()) {
    const std::string near = nearest(given.get_ref<const std::string&>(), port.choices);
    if (!near.empty()) return replacement(pointer, near);
    if (!port.spec.default_value.is_null()) return replacement(pointer, port.spec.default_value);
  }
  return nullptr;
}

Json link_removal(const std::string& node, const NodeEntry& entry, const std::string& source) {
  Json patch = Json::array();
  for (const auto& [port, input] : entry.inputs) {
    std::vector<std::size_t> linked;
    for (std::size_t item = 0; item < input.items.size(); ++item) {
      const auto* link = std::get_if<Link>(&input.items[item]);
      if (link != nullptr && link->node == source) linked.push_back(item);
    }
    if (!linked.empty() && linked.size() == input.items.size()) {
      patch.push_back({{"op", "remove"}, {"path", input_pointer(node, port)}});
      continue;
    }
    // From the last one, so that the places of the others stay.
    for (; !linked.empty(); linked.pop_back()) {
      patch.push_back({{"op", "remove"}, {"path", item_pointer(node, port, input, linked.back())}});
    }
  }
  return patch;
}

}  // namespace dini

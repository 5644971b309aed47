#pragma once

// Names in a document, and how they are looked for.

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace dini {

/// The names of things that have one, in their order.
template <class Named>
std::vector<std::string> all_names(const std::vector<Named>& all) {
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Named& one : all) names.push_back(one.name);
  return names;
}

/// The keys of a map, in their order.
template <class Map>
std::vector<std::string> keys_of(const Map& map) {
  std::vector<std::string> keys;
  keys.reserve(map.size());
  for (const auto& [key, value] : map) keys.push_back(key);
  return keys;
}

/// The first thing of that name; the end where there is none.
template <class Named>
auto find_named(const std::vector<Named>& all, std::string_view name) {
  return std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
}

template <class Named>
bool has_name(const std::vector<Named>& all, std::string_view name) {
  return find_named(all, name) != all.end();
}

/// "node" or "node.output" in its two parts; the second is empty without a period.
struct PlaceName {
  std::string node, output;
  bool has_output = false;  ///< there was a period
};
inline PlaceName place_name(std::string_view text) {
  const std::size_t period = text.find('.');
  if (period == std::string_view::npos) return {std::string(text), "", false};
  return {std::string(text.substr(0, period)), std::string(text.substr(period + 1)), true};
}

}  // namespace dini

#include "graph/order.h"

#include <algorithm>
#include <map>
#include <set>

namespace dini {

namespace {

/// Walks backwards from a node that could not be ordered until a node repeats: that loop is a cycle.
std::vector<std::string> find_cycle(const Document& document, const std::set<std::string>& ordered) {
  std::string at;
  for (const auto& [id, node] : document.nodes) {
    if (!ordered.contains(id)) {
      at = id;
      break;
    }
  }
  std::vector<std::string> walk;
  while (std::find(walk.begin(), walk.end(), at) == walk.end()) {
    walk.push_back(at);
    const std::vector<std::string> sources = sources_of(document.nodes.at(at));
    at = *std::find_if(sources.begin(), sources.end(), [&](const std::string& source) {
      return document.nodes.contains(source) && !ordered.contains(source);
    });
  }
  std::vector<std::string> cycle(std::find(walk.begin(), walk.end(), at), walk.end());
  std::reverse(cycle.begin(), cycle.end());
  return cycle;
}

}  // namespace

std::vector<std::string> sources_of(const NodeEntry& node) {
  std::vector<std::string> sources;
  std::set<std::string> seen;
  for (const auto& [port, entry] : node.inputs) {
    for (const InputItem& item : entry.items) {
      const auto* link = std::get_if<Link>(&item);
      if (link != nullptr && seen.insert(link->node).second) sources.push_back(link->node);
    }
  }
  return sources;
}

Order evaluation_order(const Document& document) {
  std::map<std::string, std::size_t> waiting_for;
  std::map<std::string, std::vector<std::string>> followers;
  std::set<std::string> ready;
  for (const auto& [id, node] : document.nodes) {
    std::size_t& count = waiting_for[id];
    for (const std::string& source : sources_of(node)) {
      if (!document.nodes.contains(source)) continue;
      ++count;
      followers[source].push_back(id);
    }
    if (count == 0) ready.insert(id);
  }
  Order order;
  std::set<std::string> ordered;
  while (!ready.empty()) {
    const std::string id = *ready.begin();
    ready.erase(ready.begin());
    order.ids.push_back(id);
    ordered.insert(id);
    for (const std::string& follower : followers[id]) {
      if (--waiting_for[follower] == 0) ready.insert(follower);
    }
  }
  if (ordered.size() < document.nodes.size()) order.cycle = find_cycle(document, ordered);
  return order;
}

}  // namespace dini

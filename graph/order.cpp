#include "graph/order.h"

#include <algorithm>
#include <map>

namespace dini {

namespace {

/// Walks backwards from the first of some nodes that each wait for another of them, until a node repeats: that loop is
/// a cycle.
std::vector<std::string> find_cycle(const Document& document, const std::map<std::string, std::size_t>& waiting) {
  std::string at = waiting.begin()->first;
  std::vector<std::string> walk;
  std::map<std::string, std::size_t> steps;
  while (steps.emplace(at, walk.size()).second) {
    walk.push_back(at);
    const std::vector<std::string> sources = sources_of(document.nodes.at(at));
    at = *std::find_if(sources.begin(), sources.end(),
                       [&](const std::string& source) { return waiting.contains(source); });
  }
  std::vector<std::string> cycle(walk.begin() + static_cast<std::ptrdiff_t>(steps.at(at)), walk.end());
  std::reverse(cycle.begin(), cycle.end());
  return cycle;
}

/// Takes nodes away as nothing is left that they wait for.
class Queue {
 public:
  explicit Queue(const Document& document) {
    for (const auto& [id, node] : document.nodes) {
      std::size_t& count = waiting_[id];
      for (const std::string& source : sources_of(node)) {
        if (!document.nodes.contains(source)) continue;
        ++count;
        followers_[source].push_back(id);
      }
    }
    for (const auto& [id, count] : waiting_) {
      if (count == 0) ready_.insert(id);
    }
  }

  /// The nodes that still wait for others, with how many.
  const std::map<std::string, std::size_t>& waiting() const { return waiting_; }

  /// Everything that can be taken now.
  std::vector<std::string> take_ready() {
    std::vector<std::string> taken;
    while (!ready_.empty()) {
      taken.push_back(*ready_.begin());
      take(taken.back());
    }
    return taken;
  }

  /// Takes a node although it waits for others.
  void take(const std::string& id) {
    ready_.erase(id);
    waiting_.erase(id);
    for (const std::string& follower : followers_[id]) {
      const auto found = waiting_.find(follower);
      if (found != waiting_.end() && --found->second == 0) ready_.insert(follower);
    }
  }

 private:
  std::map<std::string, std::size_t> waiting_;
  std::map<std::string, std::vector<std::string>> followers_;
  std::set<std::string> ready_;
};

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
  Queue queue(document);
  Order order;
  order.ids = queue.take_ready();
  while (!queue.waiting().empty()) {
    order.cycles.push_back(find_cycle(document, queue.waiting()));
    for (const std::string& id : order.cycles.back()) queue.take(id);
    queue.take_ready();  // what was only behind that cycle
  }
  return order;
}

std::set<std::string> needed_for(const Document& document, const std::vector<std::string>& targets) {
  std::set<std::string> needed;
  std::vector<std::string> stack = targets;
  while (!stack.empty()) {
    const std::string id = std::move(stack.back());
    stack.pop_back();
    const auto found = document.nodes.find(id);
    if (found == document.nodes.end() || !needed.insert(id).second) continue;
    for (std::string& source : sources_of(found->second)) stack.push_back(std::move(source));
  }
  return needed;
}

}  // namespace dini

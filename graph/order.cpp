#include "graph/order.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <queue>
#include <string_view>
#include <unordered_map>

namespace dini {

namespace {

/// The nodes of a document by number, in the order of their ids, with the numbers of those that they link to, once
/// for each link.
class Links {
 public:
  explicit Links(const Document& document) {
    numbers_.reserve(document.nodes.size());
    for (const auto& [id, node] : document.nodes) {
      numbers_.emplace(id, ids_.size());
      ids_.push_back(&id);
    }
    sources_.resize(ids_.size());
    std::size_t at = 0;
    for (const auto& [id, node] : document.nodes) {
      for (const std::string* source : sources_of(node)) {
        if (const std::optional<std::size_t> number = number_of(*source)) sources_[at].push_back(*number);
      }
      ++at;
    }
  }

  std::size_t size() const { return ids_.size(); }
  const std::string& id(std::size_t number) const { return *ids_[number]; }
  const std::vector<std::size_t>& sources(std::size_t number) const { return sources_[number]; }
  std::optional<std::size_t> number_of(std::string_view id) const {
    const auto found = numbers_.find(id);
    return found == numbers_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::vector<const std::string*> ids_;
  std::vector<std::vector<std::size_t>> sources_;
  std::unordered_map<std::string_view, std::size_t> numbers_;
};

/// Takes nodes away as nothing is left that they wait for.
class Queue {
 public:
  explicit Queue(const Links& links)
      : links_(links), waiting_(links.size()), is_taken_(links.size(), false), followers_(links.size()) {
    for (std::size_t node = 0; node < links.size(); ++node) {
      waiting_[node] = links.sources(node).size();
      for (const std::size_t source : links.sources(node)) followers_[source].push_back(node);
      if (waiting_[node] == 0) ready_.push(node);
    }
  }

  /// The first node that still waits for others, if there is one.
  std::optional<std::size_t> first_waiting() const {
    const auto found = std::ranges::find(is_taken_, false);
    return found == is_taken_.end() ? std::nullopt : std::optional<std::size_t>(found - is_taken_.begin());
  }

  /// Everything that can be taken now.
  std::vector<std::string> take_ready() {
    std::vector<std::string> taken;
    while (!ready_.empty()) {
      const std::size_t node = ready_.top();
      ready_.pop();
      if (is_taken_[node]) continue;
      taken.push_back(links_.id(node));
      take(node);
    }
    return taken;
  }

  /// Takes a node although it may wait for others.
  void take(std::size_t node) {
    is_taken_[node] = true;
    for (const std::size_t follower : followers_[node]) {
      if (--waiting_[follower] == 0 && !is_taken_[follower]) ready_.push(follower);
    }
  }

  /// Walks backwards from a node of some that each wait for another of them, until a node repeats: that loop is a
  /// cycle.
  std::vector<std::size_t> find_cycle(std::size_t at) const {
    std::vector<std::size_t> walk;
    std::map<std::size_t, std::size_t> steps;
    while (steps.emplace(at, walk.size()).second) {
      walk.push_back(at);
      at = *std::ranges::find_if(links_.sources(at), [&](std::size_t source) { return !is_taken_[source]; });
    }
    std::vector<std::size_t> cycle(walk.begin() + static_cast<std::ptrdiff_t>(steps.at(at)), walk.end());
    std::ranges::reverse(cycle);
    return cycle;
  }

 private:
  const Links& links_;
  std::vector<std::size_t> waiting_;  ///< for how many links each still waits
  std::vector<bool> is_taken_;
  std::vector<std::vector<std::size_t>> followers_;
  std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> ready_;
};

}  // namespace

std::vector<const std::string*> sources_of(const NodeEntry& node) {
  std::vector<const std::string*> sources;
  for (const auto& [port, entry] : node.inputs) {
    for (const InputItem& item : entry.items) {
      if (const auto* link = std::get_if<Link>(&item)) sources.push_back(&link->node);
    }
  }
  return sources;
}

Order evaluation_order(const Document& document) {
  const Links links(document);
  Queue queue(links);
  Order order;
  order.ids = queue.take_ready();
  while (const std::optional<std::size_t> first = queue.first_waiting()) {
    order.cycles.emplace_back();
    for (const std::size_t node : queue.find_cycle(*first)) {
      order.cycles.back().push_back(links.id(node));
      queue.take(node);
    }
    queue.take_ready();  // what was only behind that cycle
  }
  return order;
}

std::set<std::string> needed_for(const Document& document, const std::vector<std::string>& targets) {
  const Links links(document);
  std::vector<bool> is_needed(links.size(), false);
  std::vector<std::size_t> stack;
  const auto add = [&](std::size_t node) {
    if (!is_needed[node]) stack.push_back(node);
    is_needed[node] = true;
  };
  for (const std::string& target : targets) {
    if (const std::optional<std::size_t> node = links.number_of(target)) add(*node);
  }
  while (!stack.empty()) {
    const std::size_t node = stack.back();
    stack.pop_back();
    for (const std::size_t source : links.sources(node)) add(source);
  }
  std::set<std::string> needed;
  for (std::size_t node = 0; node < links.size(); ++node) {
    if (is_needed[node]) needed.insert(needed.end(), links.id(node));
  }
  return needed;
}

}  // namespace dini

#include "service/graph_merge.h"

#include <memory>
#include <vector>

#include "graph/json_reader.h"

namespace dini {

namespace {

using Path = std::vector<std::string>;

/// Where the names are that lead to a node: after "nodes", or after "groups", a name and "nodes".
std::size_t begin_of_node(const Path& path) {
  constexpr std::size_t in_group = 3;
  if (!path.empty() && path.front() == "nodes") return 1;
  return path.size() >= in_group && path.front() == "groups" && path[2] == "nodes" ? in_group : path.size();
}

/// Literals, links and parameters of an input are objects too, but never half of one and half of the other.
bool is_one_thing(const Path& path) {
  constexpr std::size_t of_input = 3;  // id, inputs, port
  return path.size() - begin_of_node(path) >= of_input;
}

Problem conflict_at(const Path& path) {
  constexpr std::size_t of_member = 2;  // id, member
  Problem problem{.code = "merge-conflict", .detail = "both sides changed it", .pointer = ""};
  for (const std::string& name : path) *problem.pointer += "/" + pointer_token(name);
  const std::size_t begin = begin_of_node(path);
  if (begin == path.size()) return problem;
  // A node of a group has no one place, and no one id.
  if (path.front() == "nodes") problem.node = path[begin];
  if (is_one_thing(path)) {
    problem.port = path.back();
  } else if (path.size() - begin == of_member) {
    problem.detail = "both sides changed its " + path.back();
  }
  return problem;
}

const OrderedJson* member_of(const OrderedJson* owner, const std::string& name) {
  if (owner == nullptr || !owner->is_object()) return nullptr;
  const auto found = owner->find(name);
  return found == owner->end() ? nullptr : &*found;
}

/// Equal values; or nothing on both sides.
bool same(const OrderedJson* a, const OrderedJson* b) {
  if (a == nullptr || b == nullptr) return a == b;
  // The order of members means nothing, which plain JSON knows.
  return nlohmann::json(*a) == nlohmann::json(*b);
}

class Merger {
 public:
  /// Sides that have nothing at a place are null. The answer is null when the merged document has nothing there.
  /// Recursion is as deep as the documents, which their reader bounds.
  std::unique_ptr<OrderedJson> merge(const OrderedJson* base, const OrderedJson* ours, const OrderedJson* theirs) {
    if (same(ours, theirs) || same(base, theirs)) return copy(ours);
    if (same(base, ours)) return copy(theirs);
    const bool has_members = ours != nullptr && theirs != nullptr && ours->is_object() && theirs->is_object();
    if (!has_members || is_one_thing(path_)) {
      conflicts_.push_back(conflict_at(path_));
      return copy(ours);
    }
    auto merged = std::make_unique<OrderedJson>(OrderedJson::object());
    for (const auto& [name, value] : ours->items()) {
      add(*merged, name, base, &value, member_of(theirs, name));
    }
    for (const auto& [name, value] : theirs->items()) {
      if (!ours->contains(name)) add(*merged, name, base, nullptr, &value);
    }
    return merged;
  }

  Problems conflicts() && { return std::move(conflicts_); }

 private:
  static std::unique_ptr<OrderedJson> copy(const OrderedJson* value) {
    return value == nullptr ? nullptr : std::make_unique<OrderedJson>(*value);
  }

  void add(OrderedJson& merged, const std::string& name, const OrderedJson* base, const OrderedJson* ours,
           const OrderedJson* theirs) {
    path_.push_back(name);
    if (auto value = merge(member_of(base, name), ours, theirs)) merged[name] = *std::move(value);
    path_.pop_back();
  }

  Path path_;
  Problems conflicts_;
};

}  // namespace

GraphMerge merge_graphs(const OrderedJson& base, const OrderedJson& ours, const OrderedJson& theirs) {
  Merger merger;
  const auto merged = merger.merge(&base, &ours, &theirs);
  return {*merged, std::move(merger).conflicts()};
}

}  // namespace dini

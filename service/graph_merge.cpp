#include "service/graph_merge.h"

#include <span>

namespace dini {

namespace {

using Path = std::vector<std::string>;

/// Literals, links and parameters of an input are objects too, but never half of one and half of the other.
bool is_one_thing(const Path& path) {
  constexpr std::size_t of_input = 4;  // nodes, id, inputs, port
  return path.size() >= of_input && path.front() == "nodes";
}

std::string joined(std::span<const std::string> names, const char* between) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : between) + name;
  return text;
}

std::string place_of(const Path& path) {
  const std::span<const std::string> names(path);
  if (path.size() >= 2 && path[0] == "parameters") return "parameter " + joined(names.subspan(1), ".");
  if (path.size() == 2 && path[0] == "nodes") return "node " + path[1];
  if (path.size() >= 3 && path[0] == "nodes") return path[1] + "." + path.back();
  return "/" + joined(names, "/");
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
      conflicts_.push_back(place_of(path_));
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

  std::vector<std::string> conflicts() && { return std::move(conflicts_); }

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
  std::vector<std::string> conflicts_;
};

}  // namespace

GraphMerge merge_graphs(const OrderedJson& base, const OrderedJson& ours, const OrderedJson& theirs) {
  Merger merger;
  const auto merged = merger.merge(&base, &ours, &theirs);
  return {*merged, std::move(merger).conflicts()};
}

}  // namespace dini

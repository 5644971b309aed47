#include <algorithm>

#include "graph/groups.h"
#include "graph/json_reader.h"
#include "graph/literal.h"
#include "graph/names.h"
#include "graph/nearest.h"
#include "graph/registry.h"

namespace dini {

namespace {

/// Ids are as long as groups are nested, so that is bounded.
constexpr std::size_t most_nested = 16;

/// Nodes that see each other: those of the document or of one group.
struct Scope {
  std::string pointer;  ///< of what has the nodes
  const std::map<std::string, NodeEntry>& nodes;
  const std::string* name = nullptr;  ///< of the group
  const GroupEntry* group = nullptr;
};

class GroupChecker {
 public:
  GroupChecker(const Document& document, const Limits& limits, const Registry& registry)
      : document_(document), limits_(limits), registry_(registry) {}

  Problems run() {
    const bool has_instances = std::any_of(document_.nodes.begin(), document_.nodes.end(),
                                           [](const auto& node) { return !group_named(node.second.type).empty(); });
    if (document_.groups.empty() && !has_instances) return {};
    check({"", document_.nodes});
    for (const auto& [name, group] : document_.groups) {
      check({"/groups/" + pointer_token(name), group.nodes, &name, &group});
    }
    order_groups();
    if (problems_.empty()) count();
    return std::move(problems_).take();
  }

 private:
  const GroupEntry* group_of(const NodeEntry& node) const {
    const auto found = document_.groups.find(std::string(group_named(node.type)));
    return found == document_.groups.end() ? nullptr : &found->second;
  }

  void check(const Scope& scope) {
    for (const auto& [id, node] : scope.nodes) check_node(scope, id, node);
    if (scope.group == nullptr) return;
    for (std::size_t i = 0; i < scope.group->outputs.size(); ++i) {
      check_link(scope, scope.group->outputs[i].from, "", "",
                 scope.pointer + "/outputs/" + std::to_string(i) + "/from");
    }
  }

  /// `detail` is called for problems that are listed only: to find the nearest of all names takes long.
  template <class Detail>
  void add(const Scope& scope, const char* code, const Detail& detail, const std::string& node, const std::string& port,
           const std::string& pointer) {
    const bool inside = scope.group != nullptr;  // where a node has many places
    problems_.add([&] { return Problem{code, detail(), inside ? "" : node, inside ? "" : port, pointer}; });
  }

  void check_node(const Scope& scope, const std::string& id, const NodeEntry& node) {
    const std::string pointer = scope.pointer + "/nodes/" + pointer_token(id);
    const bool is_instance = !group_named(node.type).empty();
    const GroupEntry* const group = group_of(node);
    const NodeType* const type = registry_.find(node.type);
    if (is_instance && group == nullptr) {
      const auto detail = [&] {
        std::vector<std::string> known;
        for (const auto& [name, entry] : document_.groups) known.push_back("group/" + name);
        return "the document has no group for the type " + excerpt(node.type) + did_you_mean(node.type, known);
      };
      add(scope, "unknown-node-type", detail, id, "", pointer + "/type");
    } else if (!is_instance && scope.group != nullptr && type == nullptr) {
      const auto detail = [&] {
        return "there is no node type " + excerpt(node.type) + did_you_mean(node.type, keys_of(registry_.types()));
      };
      add(scope, "unknown-node-type", detail, id, "", pointer + "/type");
    }
    for (const auto& [port, input] : node.inputs) {
      const std::string place = pointer + "/inputs/" + pointer_token(port);
      const bool is_checked = group != nullptr || (scope.group != nullptr && type != nullptr);
      if (is_checked && !(group != nullptr ? has_name(group->inputs, port) : type->find_input(port) != nullptr)) {
        const auto detail = [&] {
          const std::string what = group != nullptr ? "the group " + std::string(group_named(node.type)) : type->title;
          const std::vector<std::string> known = group != nullptr ? all_names(group->inputs) : all_names(type->inputs);
          return what + " has no input " + excerpt(port) + did_you_mean(port, known);
        };
        add(scope, "unknown-port", detail, id, port, place);
      }
      for (std::size_t item = 0; item < input.items.size(); ++item) {
        check_item(scope, id, port, input.items[item], place + (input.list ? "/" + std::to_string(item) : ""));
      }
    }
  }

  void check_item(const Scope& scope, const std::string& id, const std::string& port, const InputItem& item,
                  const std::string& pointer) {
    if (const auto* link = std::get_if<Link>(&item)) check_link(scope, *link, id, port, pointer);
    const auto* input = std::get_if<InputReference>(&item);
    if (input == nullptr) return;
    if (has_name(scope.group->inputs, input->name)) return;
    const auto detail = [&] {
      return "the group " + *scope.name + " has no input " + excerpt(input->name) +
             did_you_mean(input->name, all_names(scope.group->inputs));
    };
    add(scope, "unknown-port", detail, id, port, pointer);
  }

  void check_link(const Scope& scope, const Link& link, const std::string& id, const std::string& port,
                  const std::string& pointer) {
    const auto source = scope.nodes.find(link.node);
    if (source == scope.nodes.end()) {
      const auto detail = [&] {
        const std::string where =
            scope.group != nullptr ? "the group " + *scope.name + " has no node " : "there is no node ";
        return where + excerpt(link.node) + did_you_mean(link.node, keys_of(scope.nodes));
      };
      return add(scope, "dangling-link", detail, id, port, pointer);
    }
    const GroupEntry* const group = group_of(source->second);
    const NodeType* const type = registry_.find(source->second.type);
    if (group == nullptr && (scope.group == nullptr || type == nullptr)) return;
    const auto has_output = [&](const auto& outputs) {
      return link.output.empty() ? !outputs.empty() : has_name(outputs, link.output);
    };
    if (group != nullptr ? has_output(group->outputs) : has_output(type->outputs)) return;
    const auto detail = [&] {
      const std::vector<std::string> known = group != nullptr ? all_names(group->outputs) : all_names(type->outputs);
      const std::string title = group != nullptr ? source->second.type : type->title;
      return "node " + link.node + " (" + title + ") has no output" +
             (link.output.empty() ? "" : " " + excerpt(link.output) + did_you_mean(link.output, known));
    };
    add(scope, "dangling-link", detail, id, port, pointer);
  }

  /// Groups so that each stands after those that it contains.
  void order_groups() {
    enum class State { waiting, open, done };
    std::map<std::string, State> states;
    for (const auto& [start, entry] : document_.groups) {
      std::vector<std::string> path = {start};
      while (!path.empty()) {
        const std::string at = path.back();
        State& state = states[at];
        if (state == State::done) {
          path.pop_back();
          continue;
        }
        const bool first_visit = state == State::waiting;
        state = first_visit ? State::open : State::done;
        if (!first_visit) {
          order_.push_back(at);
          path.pop_back();
          continue;
        }
        for (const auto& [id, node] : document_.groups.at(at).nodes) {
          if (group_of(node) == nullptr) continue;
          const std::string inner(group_named(node.type));
          if (states[inner] == State::open) {
            report_recursion(inner, at, id);
          } else if (states[inner] == State::waiting) {
            path.push_back(inner);
          }
        }
      }
    }
  }

  void report_recursion(const std::string& group, const std::string& at, const std::string& id) {
    const std::string through = at == group ? "" : ", through the group " + at;
    problems_.add({.code = "recursive-group",
                   .detail = "the group " + group + " contains itself" + through,
                   .pointer = "/groups/" + pointer_token(at) + "/nodes/" + pointer_token(id) + "/type"});
  }

  /// Sizes of all groups with what is in them, each after those in it.
  void count() {
    std::map<std::string, std::size_t> sizes, depths;
    const auto size_of = [&](const std::map<std::string, NodeEntry>& nodes) {
      std::size_t size = 0;
      for (const auto& [id, node] : nodes) {
        const std::string inner(group_named(node.type));
        // Beyond the limit it does not matter by how much, and sums stay in bounds.
        size = std::min(size + (inner.empty() ? 1 : sizes.at(inner)), limits_.nodes + 1);
      }
      return size;
    };
    for (const std::string& name : order_) {
      const GroupEntry& group = document_.groups.at(name);
      // An empty one counts too, or there might be any number of them.
      sizes[name] = std::max<std::size_t>(1, size_of(group.nodes));
      std::size_t depth = 0;
      for (const auto& [id, node] : group.nodes) {
        const std::string inner(group_named(node.type));
        if (!inner.empty()) depth = std::max(depth, depths.at(inner));
      }
      depths[name] = depth + 1;
      if (depth + 1 <= most_nested) continue;
      problems_.add({.code = "limit-exceeded",
                     .detail = "groups are nested " + std::to_string(depth + 1) + " deep, at most " +
                               std::to_string(most_nested) + " are accepted",
                     .pointer = "/groups/" + pointer_token(name)});
      return;
    }
    if (size_of(document_.nodes) > limits_.nodes) {
      problems_.add({.code = "limit-exceeded",
                     .detail = "with those in its groups the graph has more than " + std::to_string(limits_.nodes) +
                               " nodes, which is the most that is accepted",
                     .pointer = "/nodes"});
    }
  }

  const Document& document_;
  const Limits& limits_;
  const Registry& registry_;
  ProblemCollector problems_;
  std::vector<std::string> order_;
};

}  // namespace

std::string_view group_named(std::string_view type) {
  constexpr std::string_view prefix = "group/";
  return type.starts_with(prefix) ? type.substr(prefix.size()) : std::string_view();
}

Problems problems_of_groups(const Document& document, const Limits& limits, const Registry& registry) {
  return GroupChecker(document, limits, registry).run();
}

}  // namespace dini

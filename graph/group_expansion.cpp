#include <algorithm>
#include <deque>

#include "graph/groups.h"
#include "graph/json_reader.h"
#include "graph/literal.h"
#include "graph/names.h"
#include "graph/registry.h"

namespace dini {

namespace {

/// Nodes that see each other: those of the document, or those of a group at one of the places where it stands.
struct CopyScope {
  std::string prefix = {};   ///< of the ids, "" or "ring/"
  std::string pointer = {};  ///< of what has the nodes
  const std::map<std::string, NodeEntry>* nodes = nullptr;
  const GroupEntry* group = nullptr;    ///< null for the document
  const NodeEntry* instance = nullptr;  ///< which stands in `around`
  const CopyScope* around = nullptr;
  std::string instance_pointer = {};

  std::string pointer_of(const std::string& id) const { return pointer + "/nodes/" + pointer_token(id); }
};

/// Something that is given to an input, on its way out of the groups around it.
struct Step {
  const CopyScope* scope = nullptr;
  const InputItem* item = nullptr;
  std::string pointer;
  bool passed_in = false;    ///< through an input of a group
  std::size_t bypassed = 0;  ///< so many bypassed instances passed it on
};

/// What an input is given in the end.
struct Gathered {
  InputEntry entry;
  std::vector<std::string> pointers;  ///< of the items
  bool passed_in = false;             ///< something came through an input of a group
  std::optional<std::string> absent;  ///< where it could be given what nothing gives
};

class Expander {
 public:
  Expander(Document& written, const Limits& limits, const Registry& registry)
      : written_(written), limits_(limits), registry_(registry) {}

  Result<Document> run() {
    find_scopes();
    Document flat;
    flat.format = written_.format;
    for (const CopyScope& scope : scopes_) {
      for (const auto& [id, node] : *scope.nodes) {
        if (group_named(node.type).empty()) {
          add_node(scope, id, node, flat);
        } else if (!node.bypass) {
          add_instance(scope, id, flat);
        }
        if (!problems_.empty()) return std::move(problems_).take();
      }
    }
    flat.schema = std::move(written_.schema);
    flat.meta = std::move(written_.meta);
    flat.ui = std::move(written_.ui);
    flat.parameters = std::move(written_.parameters);
    return flat;
  }

 private:
  const GroupEntry& group_of(const NodeEntry& node) const {
    return written_.groups.at(std::string(group_named(node.type)));
  }

  void find_scopes() {
    scopes_.push_back({.nodes = &written_.nodes});
    for (std::size_t k = 0; k < scopes_.size(); ++k) {
      const CopyScope& scope = scopes_[k];
      for (const auto& [id, node] : *scope.nodes) {
        if (group_named(node.type).empty()) continue;
        if (node.bypass) {
          ++bypasses_;
          continue;
        }
        const GroupEntry& group = group_of(node);
        const std::string path = scope.prefix + id;
        scopes_.push_back({path + "/", "/groups/" + pointer_token(group_named(node.type)), &group.nodes, &group, &node,
                           &scope, scope.pointer_of(id)});
        by_path_[path] = &scopes_.back();
      }
    }
  }

  void add_node(const CopyScope& scope, const std::string& id, const NodeEntry& node, Document& flat) {
    const std::string path = scope.prefix + id;
    NodeEntry entry{node.type, {}, node.bypass};
    NodePlace place{scope.pointer_of(id), {}};
    const NodeType* const type = registry_.find(node.type);
    for (const auto& [port, input] : node.inputs) {
      const InputPort* const card = type != nullptr ? type->find_input(port) : nullptr;
      Gathered gathered = gather(scope, input, place.pointer + "/inputs/" + pointer_token(port), card, path, port);
      if (gathered.entry.items.empty() && gathered.absent) {
        place.inputs[port] = {*gathered.absent};
        continue;
      }
      if (gathered.passed_in) place.inputs[port] = std::move(gathered.pointers);
      entry.inputs.emplace(port, std::move(gathered.entry));
    }
    if (scope.group != nullptr) flat.places.emplace(path, std::move(place));
    if (!flat.nodes.emplace(path, std::move(entry)).second) {
      problems_.add({.code = "invalid-id",
                     .detail = "the node " + path + " is there twice: by its own id, and in the group of an instance",
                     .pointer = "/nodes/" + pointer_token(path)});
    }
  }

  /// What stands at the outputs of an instance, in their order.
  void add_instance(const CopyScope& scope, const std::string& id, Document& flat) {
    const std::string path = scope.prefix + id;
    const CopyScope& inside = *by_path_.at(path);
    std::vector<GroupOutput>& outputs = flat.instances[path];
    for (std::size_t i = 0; i < inside.group->outputs.size() && problems_.empty(); ++i) {
      const GroupOutput& output = inside.group->outputs[i];
      const InputItem item = output.from;
      const std::string pointer = inside.pointer + "/outputs/" + std::to_string(i) + "/from";
      const Gathered gathered = gather(inside, {{item}, false}, pointer, nullptr, path, "");
      const auto* link = gathered.entry.items.empty() ? nullptr : std::get_if<Link>(&gathered.entry.items.front());
      if (link != nullptr) outputs.push_back({output.name, *link});
    }
  }

  Gathered gather(const CopyScope& scope, const InputEntry& input, const std::string& pointer, const InputPort* card,
                  const std::string& node, const std::string& port) {
    Gathered gathered;
    gathered.entry.list = input.list;
    steps_.clear();
    push({&scope, nullptr, pointer}, input);
    while (!steps_.empty() && problems_.empty()) {
      const Step step = std::move(steps_.back());
      steps_.pop_back();
      // Lists of inputs that pass on lists grow with every group around them, even where nothing is given in the end.
      if (++steps_taken_ > limits_.json_values) {
        report_limit(limits_.json_values, "values");
      } else if (step.bypassed > bypasses_) {
        // Whoever meets more bypassed instances than there are meets one again.
        problems_.add(
            {"graph-has-cycle", "bypassed groups pass on each other's values in a cycle", node, port, step.pointer});
      } else if (const auto* link = std::get_if<Link>(step.item)) {
        follow(step, *link, gathered);
      } else if (const auto* reference = std::get_if<InputReference>(step.item)) {
        look_around(step, *reference, card, gathered);
      } else if (const auto* literal = std::get_if<WrittenLiteral>(step.item)) {
        take(step, *literal, card, gathered);
      } else {
        take(step, *step.item, gathered);
      }
    }
    return gathered;
  }

  /// Items of an input whose place is that of `at`, so that the first one is the next to be looked at.
  void push(const Step& at, const InputEntry& input) {
    for (std::size_t k = input.items.size(); k-- > 0;) {
      Step& step = steps_.emplace_back(at);
      step.item = &input.items[k];
      if (input.list) step.pointer += "/" + std::to_string(k);
    }
  }

  /// Takes the node that a link leads to in the end, or what the bypassed instance passes on that it meets before.
  void follow(const Step& step, Link link, Gathered& gathered) {
    const CopyScope* scope = step.scope;
    for (;;) {
      const auto found = scope->nodes->find(link.node);
      if (found == scope->nodes->end() || group_named(found->second.type).empty()) {
        return take(step, Link{scope->prefix + link.node, link.output}, gathered);
      }
      const NodeEntry& instance = found->second;
      if (instance.bypass) return pass_on(step, *scope, link.node, instance);
      scope = by_path_.at(scope->prefix + link.node);
      const std::vector<GroupOutput>& outputs = scope->group->outputs;
      link = (link.output.empty() ? outputs.begin() : find_named(outputs, link.output))->from;
    }
  }

  /// What a bypassed instance is linked to at its first input goes on.
  void pass_on(const Step& step, const CopyScope& scope, const std::string& id, const NodeEntry& instance) {
    const GroupEntry& group = group_of(instance);
    const auto input = group.inputs.empty() ? instance.inputs.end() : instance.inputs.find(group.inputs.front().name);
    const bool is_linked = input != instance.inputs.end() && input->second.items.size() == 1 &&
                           !std::holds_alternative<WrittenLiteral>(input->second.items.front()) &&
                           !std::holds_alternative<ParameterReference>(input->second.items.front());
    if (is_linked) {
      steps_.push_back({&scope, &input->second.items.front(), step.pointer, true, step.bypassed + 1});
      return;
    }
    problems_.add({"required-input-missing", "a bypassed node needs a link at its first input", scope.prefix + id,
                   group.inputs.empty() ? "" : group.inputs.front().name, scope.pointer_of(id)});
  }

  /// What the instance gives to an input of its group.
  void look_around(const Step& step, const InputReference& reference, const InputPort* card, Gathered& gathered) {
    const CopyScope& scope = *step.scope;
    gathered.passed_in = true;
    const auto given = scope.instance->inputs.find(reference.name);
    const std::vector<GroupInput>& inputs = scope.group->inputs;
    const auto input = find_named(inputs, reference.name);
    const std::string pointer = scope.instance_pointer + "/inputs/" + pointer_token(reference.name);
    if (given != scope.instance->inputs.end()) {
      gathered.entry.list = gathered.entry.list || given->second.list;
      push({scope.around, nullptr, pointer, true, step.bypassed}, given->second);
    } else if (input->default_value) {
      Step usual = step;
      usual.pointer = scope.pointer + "/inputs/" + std::to_string(input - inputs.begin()) + "/default";
      usual.passed_in = true;
      take(usual, WrittenLiteral{*input->default_value}, card, gathered);
    } else {
      gathered.absent = pointer;
    }
  }

  /// A literal that came through an input of a group is read for the input that it reached.
  void take(const Step& step, const WrittenLiteral& literal, const InputPort* card, Gathered& gathered) {
    const auto read = [&](const Json& written, std::string pointer) {
      const Json named = card != nullptr && card->spec.is_axis_name ? axis_name(*step.scope, written) : written;
      Step at = step;
      at.pointer = std::move(pointer);
      take(at, WrittenLiteral{named, card != nullptr ? read_literal(named, *card) : Readings{}}, gathered);
    };
    const bool is_list = step.passed_in && literal.written.is_array() && card != nullptr && card->spec.takes_several;
    if (is_list) {
      gathered.entry.list = true;
      for (std::size_t i = 0; i < literal.written.size() && problems_.empty(); ++i) {
        read(literal.written[i], step.pointer + "/" + std::to_string(i));
      }
    } else if (step.passed_in || (card != nullptr && card->spec.is_axis_name)) {
      read(literal.written, step.pointer);
    } else {
      take(step, InputItem(literal), gathered);
    }
  }

  void take(const Step& step, InputItem item, Gathered& gathered) {
    links_ += std::holds_alternative<Link>(item) ? 1 : 0;
    if (const auto* literal = std::get_if<WrittenLiteral>(&item)) count(literal->written);
    if (links_ > limits_.links) return report_limit(limits_.links, "links");
    if (values_ > limits_.json_values) return report_limit(limits_.json_values, "values");
    if (text_bytes_ > limits_.body_bytes) return report_limit(limits_.body_bytes, "bytes of texts");
    gathered.passed_in = gathered.passed_in || step.passed_in;
    gathered.entry.items.push_back(std::move(item));
    gathered.pointers.push_back(step.pointer);
  }

  /// A literal is as large as it likes, and is copied for every place where its group stands.
  void count(const Json& literal) {
    ++values_;
    if (literal.is_string()) text_bytes_ += literal.get_ref<const std::string&>().size();
    if (!literal.is_array()) return;
    for (const Json& item : literal) count(item);
  }

  void report_limit(std::size_t most, const std::string& what) {
    problems_.add({.code = "limit-exceeded",
                   .detail = "with those in its groups the graph has more than " + std::to_string(most) + " " + what +
                             ", which is the most that is accepted",
                   .pointer = "/nodes"});
  }

  /// Axes that are called after nodes follow them into their paths.
  static Json axis_name(const CopyScope& scope, const Json& written) {
    if (scope.prefix.empty() || !written.is_string()) return written;
    const auto& text = written.get_ref<const std::string&>();
    return scope.nodes->contains(text.substr(0, text.find('/'))) ? Json(scope.prefix + text) : written;
  }

  Document& written_;
  const Limits& limits_;
  const Registry& registry_;
  std::deque<CopyScope> scopes_;
  std::map<std::string, const CopyScope*> by_path_;
  std::size_t bypasses_ = 0, links_ = 0, values_ = 0, text_bytes_ = 0, steps_taken_ = 0;
  std::vector<Step> steps_;
  ProblemCollector problems_;
};

}  // namespace

Result<Document> expanded(Document document, const Limits& limits, const Registry& registry) {
  Problems problems = problems_of_groups(document, limits, registry);
  if (!problems.empty()) return problems;
  if (document.groups.empty()) return document;
  return Expander(document, limits, registry).run();
}

}  // namespace dini

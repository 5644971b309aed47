#pragma once

// How a node is declared: plain functions, and one card. nodes/transforms.cpp and CONTRIBUTING.md have examples.
//
// Inputs are described in the order in which people see them. The first one may be the value that a function takes by
// itself; every other one names the member of the function's struct of inputs that it goes to. The compiler knows the
// types of both, `Registry::add` refuses a card that leaves a member out.

#include <map>
#include <set>
#include <typeindex>
#include <utility>

#include "graph/field_count.h"
#include "graph/lift_batched.h"
#include "graph/lift_single.h"
#include "graph/node_type.h"

namespace dini {

/// A node type while it is declared, and what is needed to know that its card is complete.
struct Declaration {
  /// One function: its first value, and what its struct of inputs is made of.
  struct Function {
    std::optional<InputSlot> first;
    MakeReader read_first = nullptr;
    std::map<std::type_index, std::size_t> structs;  ///< members of each class that a bound member belongs to
    std::size_t bound = 0;
    std::set<void*> places;        ///< of the bound members
    std::shared_ptr<void> sample;  ///< some inputs, for the places
  };

  NodeType type;
  std::vector<Function> functions;  ///< as `type.overloads`

  void add_port(std::string name, std::string doc, InputSpec spec);
  /// The first input: what every function takes by itself.
  void add_first(std::string name, std::string doc, InputSpec spec);
  /// A text that only the card has.
  void add_card_text(std::string name, std::string doc, InputSpec spec);
  void bind(std::size_t function, InputSlot slot, MakeReader reader, std::function<void*(void*)> member);

  /// The finished type; throws std::logic_error when a card and a function do not agree.
  NodeType finish() &&;
};

/// The chain of calls that declares a node whose functions have the structs of inputs `Inputs`, one per function.
template <class... Inputs>
class NodeBuilder {
 public:
  explicit NodeBuilder(Declaration declaration) : declaration_(std::move(declaration)) {}

  NodeBuilder&& title(std::string text) && { return set(type().title, std::move(text)); }
  NodeBuilder&& family(std::string text) && { return set(type().family, std::move(text)); }
  /// Other words, in lower case, by which people look for the node: "lathe", "ring".
  NodeBuilder&& synonyms(std::vector<std::string> words) && { return set(type().synonyms, std::move(words)); }
  NodeBuilder&& doc(std::string text) && { return set(type().doc, std::move(text)); }
  NodeBuilder&& source(std::string text) && { return set(type().source, std::move(text)); }
  NodeBuilder&& details(std::string text) && { return set(type().details, std::move(text)); }
  /// What happens with one kind of singular input, in the words that all nodes use for it.
  NodeBuilder&& degenerate(std::string input, std::string result) && {
    type().degenerate.push_back({std::move(input), std::move(result)});
    return std::move(*this);
  }
  NodeBuilder&& version(int number) && { return set(type().version, number); }

  /// The first input: the value that every function takes by itself, each of its own type.
  NodeBuilder&& input(std::string name, std::string doc, InputSpec spec = required()) && {
    declaration_.add_first(std::move(name), std::move(doc), std::move(spec));
    return std::move(*this);
  }
  /// An input that goes to a member of the inputs of every function.
  template <class T, class Owner>
  NodeBuilder&& input(std::string name, T Owner::*member, std::string doc, InputSpec spec = required()) && {
    declaration_.add_port(std::move(name), std::move(doc), std::move(spec));
    return std::move(*this).bind_all(std::index_sequence_for<Inputs...>{}, member);
  }
  /// The same for functions with two kinds of inputs, of which each has one of the members.
  template <class T, class Owner, class U, class Other>
  NodeBuilder&& input(std::string name, T Owner::*member, U Other::*other, std::string doc,
                      InputSpec spec = required()) && {
    declaration_.add_port(std::move(name), std::move(doc), std::move(spec));
    return std::move(*this).bind_all(std::index_sequence_for<Inputs...>{}, member, other);
  }
  /// The same for three kinds of inputs.
  template <class T, class Owner, class U, class Other, class V, class Third>
  NodeBuilder&& input(std::string name, T Owner::*member, U Other::*other, V Third::*third, std::string doc,
                      InputSpec spec = required()) && {
    declaration_.add_port(std::move(name), std::move(doc), std::move(spec));
    return std::move(*this).bind_all(std::index_sequence_for<Inputs...>{}, member, other, third);
  }
  NodeBuilder&& output(std::string name, std::string doc) && {
    type().outputs.push_back({std::move(name), std::move(doc), {}});
    return std::move(*this);
  }

  /// Inputs that several nodes share: what `add` makes of this builder.
  template <class Add>
  NodeBuilder with(const Add& add) && {
    return add(std::move(*this));
  }

  /// A text that names an axis which the node makes; the rule for axes reads it.
  NodeBuilder&& made_axis(std::string name, std::string doc, const char* usual = "") && {
    declaration_.add_card_text(std::move(name), std::move(doc), defaults(usual).names_axis());
    return std::move(*this);
  }
  /// A text that names an axis which Blocks consume, the first axis first; empty text means the last axes of the first
  /// block that are left.
  NodeBuilder&& consumed_axis(std::string name, std::string doc) && {
    type().over.push_back(name);
    declaration_.add_card_text(std::move(name), std::move(doc), defaults("").names_axis());
    return std::move(*this);
  }
  /// Lists at the inputs of this node run over the axis that this text names.
  NodeBuilder&& lists_along(std::string name) && { return set(type().list_axis, std::move(name)); }
  /// The axes that outputs of type Made run over.
  NodeBuilder&& axes(AxisRule rule) && { return set(type().axes, std::move(rule)); }
  /// How many vertices each mesh made has, known before anything is computed: a bound, unless there is one besides for
  /// what clipping adds.
  NodeBuilder&& vertices(VertexRule rule, VertexRule most = nullptr) && {
    type().most_vertices = std::move(most);
    return set(type().vertices, std::move(rule));
  }
  /// The same for a node that refines the meshes it is given.
  NodeBuilder&& vertex_factor(VertexFactor factor) && { return set(type().vertex_factor, std::move(factor)); }
  /// A bound for a node whose meshes may have more than those it is given by the factor.
  NodeBuilder&& most_of_given(VertexBound bound) && { return set(type().most_of_given, std::move(bound)); }
  /// What a run needs beyond the usual for its sizes.
  NodeBuilder&& cost(CostRule rule) && { return set(type().cost, std::move(rule)); }
  NodeBuilder&& depends_on_quality() && { return set(type().depends_on_quality, true); }
  /// A draft thins each mesh that the node makes to the triangles of the context, but not below these.
  NodeBuilder&& thinned_to(FewestRule fewest) && {
    type().depends_on_quality = true;
    return set(type().fewest_triangles, std::move(fewest));
  }
  NodeBuilder&& thinned_to(std::size_t fewest) && {
    return std::move(*this).thinned_to([fewest](const Axes&) { return fewest; });
  }
  NodeBuilder&& names_parts() && { return set(type().names_parts, true); }
  NodeBuilder&& passes_on() && { return set(type().passes_on, true); }
  NodeBuilder&& makes_curves() && { return set(type().makes_curves, true); }
  NodeBuilder&& always_evaluated() && { return set(type().always_evaluated, true); }

  operator NodeType() && { return std::move(declaration_).finish(); }

 private:
  NodeType& type() { return declaration_.type; }

  template <class Member, class Given>
  NodeBuilder&& set(Member& member, Given&& given) {
    member = std::forward<Given>(given);
    return std::move(*this);
  }

  template <std::size_t... I, class... Members>
  NodeBuilder&& bind_all(std::index_sequence<I...>, Members... members) && {
    (bind_one<Inputs, I>(members...), ...);
    return std::move(*this);
  }

  template <class In, std::size_t function, class... T, class... Owner>
  void bind_one(T Owner::*... members) {
    static_assert((std::is_base_of_v<Owner, In> + ... + 0) == 1,
                  "the inputs of each function have exactly one of the members that an input goes to");
    (bind_if<In>(function, members), ...);
  }

  template <class In, class T, class Owner>
  void bind_if(std::size_t function, T Owner::*member) {
    if constexpr (std::is_base_of_v<Owner, In>) {
      declaration_.functions[function].structs.emplace(typeid(Owner), field_count<Owner>());
      declaration_.bind(function, ArgumentTraits<T>::slot(), ArgumentTraits<T>::reader,
                        [member](void* inputs) { return static_cast<void*>(&(static_cast<In*>(inputs)->*member)); });
    }
  }

  Declaration declaration_;
};

template <class R, class... A>
Overload overload_of(R (*function)(A...)) {
  using Role = Roles<std::remove_cvref_t<A>...>;
  Overload overload;
  if constexpr (std::tuple_size_v < typename Role::Outs >> 0) {
    using Lifted = BatchedFunction<R, A...>;
    overload.outputs = slots_of(std::type_identity<typename Lifted::Outputs>{});
    overload.function = Lifted(function);
  } else {
    using Lifted = SingleFunction<R, A...>;
    overload.outputs = slots_of(std::type_identity<typename Lifted::Outputs>{});
    overload.function = Lifted(function);
  }
  return overload;
}

template <class R, class... A>
Declaration::Function declared(R (*)(A...)) {
  using Role = Roles<std::remove_cvref_t<A>...>;
  Declaration::Function function;
  if constexpr (ArgumentType<typename Role::First>) {
    function.first = ArgumentTraits<typename Role::First>::slot();
    function.read_first = ArgumentTraits<typename Role::First>::reader;
  }
  function.structs.emplace(typeid(typename Role::Inputs), field_count<typename Role::Inputs>());
  function.sample = std::make_shared<typename Role::Inputs>();
  return function;
}

template <class R, class... A>
typename Roles<std::remove_cvref_t<A>...>::Inputs inputs_of(R (*)(A...));

/// Starts a declaration: the id and one function per type of the first input, all with the same inputs.
template <class... Functions>
auto node(std::string id, Functions... functions) {
  Declaration declaration;
  declaration.type.id = std::move(id);
  (declaration.type.overloads.push_back(overload_of(functions)), ...);
  (declaration.functions.push_back(declared(functions)), ...);
  return NodeBuilder<decltype(inputs_of(functions))...>(std::move(declaration));
}

/// The rule of a node with one made axis: size from the integer input `count`, name from the text input `axis` or the
/// node's id, closed as the boolean input `closed` says, or open when that is empty. `outputs` outputs run over it.
AxisRule one_axis(std::string count, std::string axis, std::string closed = "", std::size_t outputs = 1);

}  // namespace dini

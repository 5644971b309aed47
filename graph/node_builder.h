#pragma once

// How a node is declared: one plain function per type of its first input, and one card.
//
//   registry.add(node("boost", boost_points, boost_circle)
//       .title("Boost").family("transforms")
//       .doc("Bends a shape with a boosting rotor.").source("Boosted Surfaces, eqs. (2), (5)")
//       .input("shape", "What to bend.")
//       .input("amount", "Weight of the generator.", defaults(1).soft(-2, 2))
//       .output("shape", "The bent shape."));
//
// Inputs are described in the order of the functions' parameters. `Registry::add` refuses an incomplete card.

#include <utility>

#include "graph/node_type.h"

namespace dini {

template <class A>
void describe_argument(Overload& overload, std::vector<std::vector<std::string>>& choices) {
  using Traits = ArgumentTraits<A>;
  if constexpr (takes_port<A>) {
    overload.mixed_types.emplace_back();
    if constexpr (Traits::kind == ArgumentKind::mixed) {
      overload.mixed_types.back().assign(Traits::types.begin(), Traits::types.end());
      overload.inputs.push_back(Traits::types.front());
    } else {
      overload.inputs.push_back(Traits::type);
    }
    overload.input_is_optional.push_back(Traits::kind == ArgumentKind::optional);
    overload.input_is_block.push_back(Traits::kind == ArgumentKind::block);
    overload.input_is_file.push_back(std::is_same_v<A, SharedAssetFile>);
    if constexpr (Traits::kind == ArgumentKind::block) overload.consumed_axes = Traits::rank;
    choices.emplace_back();
    if constexpr (ChoiceEnum<A>) {
      for (const auto& word : ChoiceNames<A>::names) choices.back().emplace_back(word);
    }
  }
}

template <class Tuple, std::size_t... O>
void describe_outputs(Overload& overload, std::index_sequence<O...>) {
  (overload.outputs.push_back(Wire<typename OutputTraits<std::tuple_element_t<O, Tuple>>::Element>::type), ...);
  (overload.output_makes_axes.push_back(OutputTraits<std::tuple_element_t<O, Tuple>>::makes_axes), ...);
}

template <class R, class... A>
Overload make_overload(R (*function)(A...), std::vector<std::vector<std::string>>& choices) {
  Overload overload;
  choices.clear();
  (describe_argument<std::remove_cvref_t<A>>(overload, choices), ...);
  using Lifted = LiftedFunction<R, A...>;
  describe_outputs<typename Lifted::OutputTuple>(overload, std::make_index_sequence<Lifted::output_count>{});
  overload.run = Lifted(function);
  return overload;
}

class NodeBuilder {
 public:
  explicit NodeBuilder(std::string id) { type_.id = std::move(id); }

  template <class Function>
  void add_overload(Function function) {
    type_.overloads.push_back(make_overload(function, type_.choices));
  }

  NodeBuilder&& title(std::string text) && { return set(type_.title, std::move(text)); }
  NodeBuilder&& family(std::string text) && { return set(type_.family, std::move(text)); }
  NodeBuilder&& doc(std::string text) && { return set(type_.doc, std::move(text)); }
  NodeBuilder&& source(std::string text) && { return set(type_.source, std::move(text)); }
  NodeBuilder&& details(std::string text) && { return set(type_.details, std::move(text)); }
  /// What happens with one kind of singular input, in the words that all nodes use for it.
  NodeBuilder&& degenerate(std::string input, std::string result) && {
    type_.degenerate.push_back({std::move(input), std::move(result)});
    return std::move(*this);
  }
  NodeBuilder&& version(int number) && { return set(type_.version, number); }

  NodeBuilder&& input(std::string name, std::string doc, InputSpec spec = required()) && {
    type_.inputs.push_back({std::move(name), std::move(doc), std::move(spec), {}, {}, false, false});
    return std::move(*this);
  }
  NodeBuilder&& output(std::string name, std::string doc) && {
    type_.outputs.push_back({std::move(name), std::move(doc), {}});
    return std::move(*this);
  }

  /// Which text inputs name the axes that Block parameters consume; empty text means the last axes of the first block
  /// input.
  NodeBuilder&& over(std::vector<std::string> ports) && { return set(type_.over, std::move(ports)); }
  /// The axes that outputs of type Made run over.
  NodeBuilder&& axes(AxisRule rule) && { return set(type_.axes, std::move(rule)); }
  /// A bound of the vertices of each mesh made, known before anything is computed.
  NodeBuilder&& vertices(VertexRule rule) && { return set(type_.vertices, std::move(rule)); }
  /// The same for a node that refines the meshes it is given.
  NodeBuilder&& vertex_factor(VertexFactor factor) && { return set(type_.vertex_factor, std::move(factor)); }
  /// What a run needs beyond the usual for its sizes.
  NodeBuilder&& cost(CostRule rule) && { return set(type_.cost, std::move(rule)); }
  NodeBuilder&& depends_on_quality() && { return set(type_.depends_on_quality, true); }
  /// A draft thins each mesh that the node makes to the triangles of the context, but not below these.
  NodeBuilder&& thinned_to(FewestRule fewest) && {
    type_.depends_on_quality = true;
    return set(type_.fewest_triangles, std::move(fewest));
  }
  NodeBuilder&& thinned_to(std::size_t fewest) && {
    return std::move(*this).thinned_to([fewest](const Axes&) { return fewest; });
  }
  NodeBuilder&& names_parts() && { return set(type_.names_parts, true); }
  NodeBuilder&& passes_on() && { return set(type_.passes_on, true); }
  NodeBuilder&& makes_curves() && { return set(type_.makes_curves, true); }
  NodeBuilder&& always_evaluated() && { return set(type_.always_evaluated, true); }

  operator NodeType() && { return std::move(type_); }

 private:
  template <class Member, class Given>
  NodeBuilder&& set(Member& member, Given&& given) {
    member = std::forward<Given>(given);
    return std::move(*this);
  }

  NodeType type_;
};

/// Starts a declaration: the id and one function per type of the first input, all with the same inputs.
template <class... Functions>
NodeBuilder node(std::string id, Functions... functions) {
  NodeBuilder builder(std::move(id));
  (builder.add_overload(functions), ...);
  return builder;
}

/// The rule of a node with one made axis: size from the integer input `count`, name from the text input `axis` or the
/// node's id, closed as the boolean input `closed` says.
AxisRule one_axis(std::string count, std::string axis, std::string closed);

}  // namespace dini

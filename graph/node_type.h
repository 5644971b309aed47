#pragma once

// A node type: what a card shows and what the engine runs. Built by `node(...)` in graph/node_builder.h.
//
// If a function consumes axes (Block parameters) it sees all values along them; every other axis of its inputs is
// lifted.

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "graph/lift.h"
#include "graph/port.h"

namespace dini {

/// The literals of a node by port name, for rules that need them before anything is computed.
using Literals = std::map<std::string, Literal, std::less<>>;

/// Reads literals that a card guarantees to be there.
std::int64_t integer_at(const Literals& literals, std::string_view port);
bool boolean_at(const Literals& literals, std::string_view port);
const std::string& text_at(const Literals& literals, std::string_view port);
const AssetFile& file_at(const Literals& literals, std::string_view port);

/// One function behind a node, for one type of its first input.
struct Overload {
  std::size_t number = 0;         ///< among the functions of its node
  std::vector<InputSlot> inputs;  ///< by port; a port that only the card has is a text
  std::vector<OutputSlot> outputs;
  PortBindings bindings;  ///< of the ports that the function takes
  std::function<LiftedResult(const Call&, const PortBindings&)> function;

  LiftedResult run(const Call& call) const { return function(call, bindings); }

  /// How many axes each call sees at once.
  std::size_t consumed_axes() const;
  /// The first port whose axes are consumed; nothing for a function that consumes none.
  std::optional<std::size_t> first_block() const;
};

/// The axes that a node makes, per output, from its literals and its id.
using AxisRule = std::function<std::vector<Axes>(const Literals&, const std::string& node_id)>;

/// How many vertices one mesh has that a node makes, from its literals and the consumed axes.
using VertexRule = std::function<std::size_t(const Literals&, const Axes& consumed)>;

/// The fewest triangles that a mesh over the consumed axes can be thinned to without being another one.
using FewestRule = std::function<std::size_t(const Axes& consumed)>;

/// By how much a node multiplies the vertices of its mesh inputs, from its literals.
using VertexFactor = std::function<std::size_t(const Literals&)>;

/// The most vertices that one mesh made from meshes with `given` of them has, from the node's literals. It holds for a
/// family by the mean, so it grows no faster where there are more.
using VertexBound = std::function<std::size_t(const Literals&, std::size_t given)>;

/// What one run of a node is given and makes, known before anything is computed. Sizes are bounds.
struct RunSize {
  const Literals& literals;
  const Axes& consumed;
  std::array<double, 9> given;  ///< values by wire type, at inputs that keep them apart
  double given_vertices;        ///< of all meshes that it is given
  double values;                ///< that it makes, over all outputs
  double vertices;              ///< of the meshes that it makes
  double fields;                ///< that it makes

  double given_of(WireType type) const { return given[static_cast<std::size_t>(type)]; }
};

/// What one run of a node needs beyond the usual for its sizes: work in units of about a nanosecond of one processor
/// (the usual is 40 for a number or point made, 400 for a circle, 100 for a vertex given or made), bytes while it runs,
/// and bytes that it keeps beyond numbers and meshes.
struct RunCost {
  double work = 0;
  double bytes = 0;
  double kept_bytes = 0;
};
using CostRule = std::function<RunCost(const RunSize&)>;

/// What a node does with one kind of singular input.
struct Degenerate {
  std::string input;   ///< in words: "zero direction"
  std::string result;  ///< one sentence
};

struct NodeType {
  std::string id;
  std::string title;
  std::string family;
  std::string doc;
  std::vector<std::string> synonyms;  ///< other words, in lower case, that people look for
  std::string source;                 ///< equation or figure of the paper, or another publication; may be empty
  std::string details;                ///< degenerate cases and anything else a user should know; may be empty
  std::vector<Degenerate> degenerate;
  int version = 1;  ///< raised when results change; part of the fingerprint

  std::vector<InputPort> inputs;
  std::vector<OutputPort> outputs;
  std::vector<Overload> overloads;

  std::vector<std::string> over;  ///< text inputs that name the consumed axes, in order
  std::string list_axis;          ///< the text input that names the axis of lists; empty where the node's id does
  AxisRule axes;
  VertexRule vertices;
  VertexRule most_vertices;    ///< where `vertices` is no bound; absent where it is
  VertexFactor vertex_factor;  ///< where there is no rule; 1 when absent
  VertexBound most_of_given;   ///< where the factor is no bound; absent where it is
  CostRule cost;               ///< nothing beyond the usual when absent
  bool depends_on_quality = false;
  FewestRule fewest_triangles;    ///< of each mesh that a draft thins; absent for nodes that make none
  bool names_parts = false;       ///< its result holds the names of the nodes that its values come from
  bool passes_on = false;         ///< gives on what it is given at its first input
  bool makes_curves = false;      ///< points along the axis that it makes belong to one curve
  bool always_evaluated = false;  ///< runs even when the asked output does not need it (checks)

  /// True for a node whose meshes a draft may thin.
  bool makes_meshes_by_quality() const { return static_cast<bool>(fewest_triangles); }

  const InputPort* find_input(std::string_view name) const;
  const OutputPort* find_output(std::string_view name) const;
  /// The places of ports that are there.
  std::size_t input_index(std::string_view name) const;
  std::size_t output_index(std::string_view name) const;
};

}  // namespace dini

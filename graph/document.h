#pragma once

// The graph document, formats 1 and 2: what editor, REST and command line exchange. Reading is strict, and writing what
// was read gives the same document again. Format 2 adds groups.

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "graph/limits.h"
#include "graph/problem.h"
#include "graph/reading.h"

namespace dini {

class Registry;

/// {"from": "node"} or {"from": "node.output"}.
struct Link {
  std::string node;
  std::string output;  ///< empty: the node's first output

  friend bool operator==(const Link&, const Link&) = default;
};

/// {"parameter": "name"}.
struct ParameterReference {
  std::string name;

  friend bool operator==(const ParameterReference&, const ParameterReference&) = default;
};

/// {"input": "name"}: what an instance gives to an input of its group. Nodes of groups have these.
struct InputReference {
  std::string name;

  friend bool operator==(const InputReference&, const InputReference&) = default;
};

/// A literal: as it is written, and what that means to its input. Nothing is known of one at an unknown input.
struct WrittenLiteral {
  Json written;
  Readings readings = {};

  friend bool operator==(const WrittenLiteral& a, const WrittenLiteral& b) { return a.written == b.written; }
};

/// One thing given to an input: a literal, a link, a parameter, or an input of the group around the node.
using InputItem = std::variant<WrittenLiteral, Link, ParameterReference, InputReference>;

/// What is given to an input. `list` when it was written as a list of things, each an item; any other list, such as the
/// coordinates of a point, is one literal.
struct InputEntry {
  std::vector<InputItem> items;
  bool list = false;

  friend bool operator==(const InputEntry&, const InputEntry&) = default;
};

struct NodeEntry {
  std::string type;
  std::map<std::string, InputEntry> inputs;
  bool bypass = false;

  friend bool operator==(const NodeEntry&, const NodeEntry&) = default;
};

/// A graph parameter: what a form shows and what a request may set.
struct Parameter {
  WireType type = WireType::number;  ///< number, integer, boolean, choice, vector or color
  ParameterValue default_value;
  std::optional<double> minimum, maximum, step;
  std::vector<std::string> choices;
  std::optional<std::string> unit, label, description;

  friend bool operator==(const Parameter&, const Parameter&) = default;
};

/// An input of a group. An instance that leaves it out gives the default; without one, the inputs that it reaches are
/// left out as well.
struct GroupInput {
  std::string name;
  std::optional<Json> default_value;  ///< a literal
  std::optional<std::string> label, description;

  friend bool operator==(const GroupInput&, const GroupInput&) = default;
};

/// An output of a group: that of one of its nodes.
struct GroupOutput {
  std::string name;
  Link from;

  friend bool operator==(const GroupOutput&, const GroupOutput&) = default;
};

/// Nodes that stand together wherever a node of type "group/<name>" is. What they are given from outside comes through
/// the inputs; they know no parameters.
struct GroupEntry {
  std::optional<std::string> label, description;
  std::vector<GroupInput> inputs;
  std::vector<GroupOutput> outputs;
  std::map<std::string, NodeEntry> nodes;

  friend bool operator==(const GroupEntry&, const GroupEntry&) = default;
};

/// Where in the document a node was written that a group brought in: the pointer of the node, and those of what its
/// inputs were given through inputs of groups, by port, an entry for each item.
struct NodePlace {
  std::string pointer;
  std::map<std::string, std::vector<std::string>> inputs;

  friend bool operator==(const NodePlace&, const NodePlace&) = default;
};

struct Document {
  int format = 1;
  std::optional<std::string> schema;  ///< "$schema": where its schema is, for editors; never influences evaluation
  Json meta = nullptr;                ///< free; never influences evaluation
  Json ui = nullptr;                  ///< free; never influences evaluation
  std::map<std::string, Parameter> parameters;
  std::map<std::string, NodeEntry> nodes;
  std::map<std::string, GroupEntry> groups;

  // What `expanded` of graph/groups.h leaves in place of groups.
  std::map<std::string, NodePlace> places;                    ///< of the nodes that groups brought in, by id
  std::map<std::string, std::vector<GroupOutput>> instances;  ///< by id: what stands at the outputs of each

  friend bool operator==(const Document&, const Document&) = default;
};

/// Reads a document; every structural problem at once. Its literals are read for the inputs of these node types; what
/// is wrong with one is kept with it, since only the rest of the graph tells which of its readings counts.
Result<Document> read_document(const Json& json, const Limits& limits, const Registry& registry);

Json write_document(const Document& document);

/// Ids of nodes and names of parameters and groups: [A-Za-z][A-Za-z0-9_-]{0,63}.
bool is_identifier(std::string_view text);

/// Ids joined by "/", as the nodes within groups are called: "ring/circle".
bool is_path(std::string_view text);

}  // namespace dini

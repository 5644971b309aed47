#pragma once

// The graph document, format 1: what editor, REST and command line exchange. Reading is strict, and writing what was
// read gives the same document again.

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

/// A literal: as it is written, and what that means to its input. Nothing is known of one at an unknown input.
struct WrittenLiteral {
  Json written;
  Readings readings = {};

  friend bool operator==(const WrittenLiteral& a, const WrittenLiteral& b) { return a.written == b.written; }
};

/// One thing given to an input: a literal, a link, or a parameter.
using InputItem = std::variant<WrittenLiteral, Link, ParameterReference>;

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

struct Document {
  std::optional<std::string> schema;  ///< "$schema": where its schema is, for editors; never influences evaluation
  Json meta = nullptr;                ///< free; never influences evaluation
  Json ui = nullptr;                  ///< free; never influences evaluation
  std::map<std::string, Parameter> parameters;
  std::map<std::string, NodeEntry> nodes;

  friend bool operator==(const Document&, const Document&) = default;
};

/// Reads a document; every structural problem at once. Its literals are read for the inputs of these node types; what
/// is wrong with one is kept with it, since only the rest of the graph tells which of its readings counts.
Result<Document> read_document(const Json& json, const Limits& limits, const Registry& registry);

Json write_document(const Document& document);

/// Ids of nodes and names of parameters: [A-Za-z][A-Za-z0-9_-]{0,63}.
bool is_identifier(std::string_view text);

}  // namespace dini

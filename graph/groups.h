#pragma once

// Groups of a document, and the document without them: every instance is replaced by the nodes of its group, whose ids
// are then paths such as "ring/circle". What evaluates a graph knows no groups.

#include <string>
#include <string_view>

#include "graph/document.h"

namespace dini {

/// How many inputs a group has at most, and how many outputs: each of its instances has them.
constexpr std::size_t most_group_sockets = 256;

/// The group that a node type of the form "group/<name>" means; empty for any other type.
std::string_view group_named(std::string_view type);

/// Everything that is wrong with names in and around the groups of a document that was read: groups that contain
/// themselves or are nested too deeply, types, inputs and outputs that are not there. Empty for a document without
/// groups. Sizes are counted before anything is made: nodes within groups count as often as their group stands.
Problems problems_of_groups(const Document& document, const Limits& limits, const Registry& registry);

/// The same graph without groups; the document itself where it has none. A bypassed instance passes on what its first
/// input is linked to. Names of axes in a group that are ids of its nodes are those of the nodes' paths.
Result<Document> expanded(Document document, const Limits& limits, const Registry& registry);

/// Problems of an expanded document, with pointers into the document that it was made from. A fix of something within
/// a group is kept where it only writes another literal.
Problems placed(Problems problems, const Document& document);

/// Nodes and outputs as requests write them, "node" or "node.output": what stands there when the node is an instance
/// of a group, all outputs of one that are named alone. Just the place itself for any other node.
std::vector<std::string> places_behind(const Document& document, const std::string& place);

}  // namespace dini

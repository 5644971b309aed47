#pragma once

// What would mend a problem, as JSON Patches (RFC 6902) of the graph document. Null where nothing is known.

#include <string>
#include <vector>

#include "graph/document.h"
#include "graph/port.h"

namespace dini {

/// The pointer to an input of a node, and to one item of it when `item` is given and the input is a list.
std::string input_pointer(const std::string& node, const std::string& port);
std::string item_pointer(const std::string& node, const std::string& port, const InputEntry& entry, std::size_t item);

Json replacement(const std::string& pointer, Json value);

/// The item out of its list; the whole input when it is the only one.
Json item_removal(const std::string& node, const std::string& port, const InputEntry& entry, std::size_t item);

/// A neutral literal for an input that must be given: 0 or the number nearest to it that is accepted, the origin, the
/// upward direction. Null for inputs that some links only can fill.
Json missing_input(const std::string& node, const NodeEntry& entry, const InputPort& port);

/// A literal that was refused as out of range or as no choice, replaced by the nearest one that is accepted.
Json acceptable_literal(const std::string& pointer, const std::string& code, const Json& given, const InputPort& port);

/// Removes every link of `node` to `source`.
Json link_removal(const std::string& node, const NodeEntry& entry, const std::string& source);

}  // namespace dini

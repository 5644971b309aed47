#pragma once

#include <nlohmann/json.hpp>

#include "graph/problem.h"

namespace dini {

/// A document with the order of its members.
using OrderedJson = nlohmann::ordered_json;

/// What two people made of one document. Conflicts are problems `merge-conflict` at the places that both changed, each
/// in another way, with node and input where it is one. There the merged document has what is ours.
struct GraphMerge {
  OrderedJson merged;
  Problems conflicts = {};
};

/// Merges the changes from `base` to `theirs` into `ours`. What an input is given is one thing, as is any list; all
/// else is merged member by member. The order is that of ours, and what is new in theirs comes last.
GraphMerge merge_graphs(const OrderedJson& base, const OrderedJson& ours, const OrderedJson& theirs);

}  // namespace dini

#pragma once

// Values on wires: a column of one wire type, and the axes it runs over.
//
// Axes and columns are kept apart on purpose: a cached column is reused under other axis names, because names come from
// the document while the content does not.

#include <string>
#include <variant>
#include <vector>

#include "geometry/cancel.h"
#include "geometry/family.h"
#include "graph/asset_file.h"
#include "graph/wire.h"

namespace dini {

template <class List>
struct ColumnsOf;
template <class... T>
struct ColumnsOf<WireList<T...>> {
  using Variant = std::variant<SharedColumn<T>...>;
};

/// A shared column of any wire type; the alternatives stand in the order of WireType.
using AnyColumn = ColumnsOf<WireTypes>::Variant;

/// A family of any wire type.
struct Value {
  Axes axes;
  AnyColumn column;

  WireType type() const { return static_cast<WireType>(column.index()); }
};

/// The column as one of `T`; the caller knows the type.
template <class T>
const Column<T>& column_of(const Value& value) {
  return *std::get<SharedColumn<T>>(value.column);
}

/// Memory held by a column, meshes and files included.
std::size_t bytes(const AnyColumn& column);

/// The value over the same axes as `items` together plus `axis` as the last: item i at index i of it.
/// All items have the same type, which is one of numbers; equal axis names have equal sizes (checked before).
/// Stopped early: not all values.
Value stack(const std::vector<Value>& items, const Axis& axis, const Cancel& cancel);

/// Literals that never travel on wires. A text that names a file has become the file.
using Literal = std::variant<std::int64_t, bool, std::string, Color, SharedAssetFile>;

/// Where a value comes from, for nodes that write names into what they make and for what is said about them.
struct Origin {
  std::string part;         ///< the id of the node that made it; with ".output" unless that is the node's first
  std::string description;  ///< that node and the parameters behind it, for people
};

/// Values of any types that are kept apart, and where each comes from (empty unless the node names parts).
struct Items {
  std::vector<Value> values;
  std::vector<Origin> origins;
};

/// What a node receives on one port: nothing, a value, a literal, or several values of any type.
using Argument = std::variant<std::monostate, Value, Literal, Items>;

}  // namespace dini

#pragma once

// Values on wires: a column of one wire type, and the axes it runs over.
//
// Axes and columns are kept apart on purpose: a cached column is reused under other axis names, because names come from
// the document while the content does not.

#include <string>
#include <variant>
#include <vector>

#include "geometry/family.h"
#include "graph/asset_file.h"
#include "graph/wire.h"

namespace dini {

/// A shared column of any wire type; the alternatives stand in the order of WireType.
using AnyColumn =
    std::variant<SharedColumn<double>, SharedColumn<Vector>, SharedColumn<Point>, SharedColumn<Generator>,
                 SharedColumn<Circle>, SharedColumn<Sphere>, SharedColumn<SharedMesh>, SharedColumn<SharedAsset>>;

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
Value stack(const std::vector<Value>& items, const Axis& axis);

/// Literals that never travel on wires. A text that names a file has become the file.
using Literal = std::variant<std::int64_t, bool, std::string, Color, SharedAssetFile>;

/// What a node receives on one port: nothing, a value, a literal, or several values of any type.
using Argument = std::variant<std::monostate, Value, Literal, std::vector<Value>>;

}  // namespace dini

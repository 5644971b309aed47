#pragma once

// The closed list of wire types. A wire carries a family of one of these; the literal-only types are never wired.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "algebra/elements.h"
#include "geometry/mesh.h"
#include "geometry/scalar_field.h"
#include "graph/file.h"

namespace dini {

enum class WireType : std::uint8_t {
  number,
  vector,
  point,
  generator,
  circle,
  sphere,
  mesh,
  asset,
  field,
  integer,
  text,
  choice,
  boolean,
  color,
};

/// What a reader of the catalogue needs to know about a wire type.
struct WireInfo {
  WireType type;
  std::string_view name;
  std::string_view family;  ///< Types of one family share a color.
  std::string_view color;   ///< "#RRGGBB" in sRGB, as pages write it.
  std::string_view shape;   ///< How a socket is drawn: one shape per type.
  std::string_view doc;
  bool literal_only;
};

std::span<const WireInfo> wire_types();
const WireInfo& info(WireType type);
std::string_view name(WireType type);

/// The color of a wire type as files have it: linear, opaque.
Color linear_color(WireType type);

/// The wire type of a C++ type; only wire types have one.
template <class T>
struct Wire;
template <>
struct Wire<double> {
  static constexpr WireType type = WireType::number;
};
template <>
struct Wire<Vector> {
  static constexpr WireType type = WireType::vector;
};
template <>
struct Wire<Point> {
  static constexpr WireType type = WireType::point;
};
template <>
struct Wire<Generator> {
  static constexpr WireType type = WireType::generator;
};
template <>
struct Wire<Circle> {
  static constexpr WireType type = WireType::circle;
};
template <>
struct Wire<Sphere> {
  static constexpr WireType type = WireType::sphere;
};
template <>
struct Wire<SharedMesh> {
  static constexpr WireType type = WireType::mesh;
};
template <>
struct Wire<SharedFile> {
  static constexpr WireType type = WireType::asset;
};
template <>
struct Wire<SharedField> {
  static constexpr WireType type = WireType::field;
};

/// The C++ types of wires in the order of WireType, as far as values travel on them.
template <class... T>
struct WireList {
  static constexpr bool in_order = [] {
    std::size_t place = 0;
    return ((static_cast<std::size_t>(Wire<T>::type) == place++) && ...);
  }();
};
using WireTypes = WireList<double, Vector, Point, Generator, Circle, Sphere, SharedMesh, SharedFile, SharedField>;
static_assert(WireTypes::in_order, "the list of wires is not in the order of WireType");

template <class T>
concept WireValue = requires {
  Wire<T>::type;
};

}  // namespace dini

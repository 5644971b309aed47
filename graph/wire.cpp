#include "graph/wire.h"

#include <array>
#include <charconv>

#include "algebra/elementary.h"

namespace dini {

namespace {

// Colors keep an OKLab distance of at least 0.116 under every simulated color blindness.
constexpr std::array<WireInfo, 14> types = {{
    {WireType::number, "number", "number", "#C1D7D0", "dot", "A real number.", false},
    {WireType::vector, "vector", "vector", "#2FC2FF", "circle", "A free direction in space, in meters.", false},
    {WireType::point, "point", "point", "#F2FF71", "circle", "A position in space, or the point at infinity.", false},
    {WireType::generator, "generator", "versor", "#9F68B4", "diamond",
     "A bivector: a point pair, flat point, direction, dual line or a sum of them, ready to be exponentiated.", false},
    {WireType::circle, "circle", "round", "#F3AF20", "ring", "An oriented circle or line.", false},
    {WireType::sphere, "sphere", "round", "#F3AF20", "disc", "An oriented sphere or plane.", false},
    {WireType::mesh, "mesh", "mesh", "#7F61FF", "square", "A triangle mesh.", false},
    {WireType::asset, "asset", "asset", "#F1491A", "rounded", "A finished file with its media type.", false},
    {WireType::field, "field", "field", "#A83054", "outline",
     "A number at every place of space: below zero inside a solid, and near its surface the distance from it, in "
     "meters.",
     false},
    {WireType::integer, "integer", "number", "#C1D7D0", "dot", "A whole number, written in the graph.", true},
    {WireType::text, "text", "number", "#C1D7D0", "dot", "A short text, written in the graph.", true},
    {WireType::choice, "choice", "number", "#C1D7D0", "dot", "One of a fixed list of words.", true},
    {WireType::boolean, "boolean", "number", "#C1D7D0", "dot", "True or false.", true},
    {WireType::color, "color", "number", "#C1D7D0", "dot", "Linear red, green, blue and alpha from 0 to 1.", true},
}};

constexpr bool in_order() {
  for (std::size_t k = 0; k < types.size(); ++k) {
    if (types[k].type != static_cast<WireType>(k)) return false;
  }
  return true;
}
static_assert(in_order(), "the table of wire types is not in the order of WireType");

/// One sRGB component of 0 to 255 made linear (IEC 61966-2-1).
double linear(int component) {
  const double encoded = component / 255.0;
  return encoded <= 0.04045 ? encoded / 12.92 : elementary::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace

std::span<const WireInfo> wire_types() { return types; }

const WireInfo& info(WireType type) { return types[static_cast<std::size_t>(type)]; }

std::string_view name(WireType type) { return info(type).name; }

Color linear_color(WireType type) {
  const std::string_view digits = info(type).color.substr(1);
  Color color = {0, 0, 0, 1};
  for (std::size_t k = 0; k < 3; ++k) {
    int component = 0;
    std::from_chars(digits.data() + 2 * k, digits.data() + 2 * k + 2, component, 16);
    color[k] = linear(component);
  }
  return color;
}

}  // namespace dini

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/json.h"

namespace dini {

/// What the numbers of a document count: the length that coordinates 1 apart are apart.
enum class LengthUnit : std::uint8_t { meter, centimeter, millimeter, inch };

/// The words of documents for them, in the order of the enum.
inline constexpr std::array<std::string_view, 4> length_unit_names = {"m", "cm", "mm", "in"};

inline constexpr std::string_view name(LengthUnit unit) { return length_unit_names[static_cast<std::size_t>(unit)]; }

/// Exact: an inch is 25.4 millimeters.
inline constexpr double millimeters_of(LengthUnit unit) {
  constexpr std::array<double, 4> lengths = {1000, 10, 1, 25.4};
  return lengths[static_cast<std::size_t>(unit)];
}

inline constexpr double meters_of(LengthUnit unit) { return millimeters_of(unit) / 1000; }

inline std::optional<LengthUnit> length_unit_named(std::string_view word) {
  for (std::size_t i = 0; i < length_unit_names.size(); ++i) {
    if (length_unit_names[i] == word) return static_cast<LengthUnit>(i);
  }
  return std::nullopt;
}

/// The unit that a file says about itself in its member `unit`; nothing where it says none.
inline std::optional<LengthUnit> unit_of(const Json& about) {
  if (!about.is_object() || !about.contains("unit") || !about["unit"].is_string()) return std::nullopt;
  return length_unit_named(about["unit"].get_ref<const std::string&>());
}

}  // namespace dini

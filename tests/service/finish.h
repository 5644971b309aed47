#pragma once

#include "graph/arguments.h"

namespace dini {

namespace support {

/// A choice that a toy request has.
enum class Coating { plain, shiny };

}  // namespace support

template <>
struct ChoiceNames<support::Coating> {
  static constexpr std::array<std::string_view, 2> names = {"plain", "shiny"};
};

}  // namespace dini

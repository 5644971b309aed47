#pragma once

#include "graph/arguments.h"

namespace dini {

namespace support {

/// A choice that a toy request has.
enum class Finish { plain, shiny };

}  // namespace support

template <>
struct ChoiceNames<support::Finish> {
  static constexpr std::array<std::string_view, 2> names = {"plain", "shiny"};
};

}  // namespace dini

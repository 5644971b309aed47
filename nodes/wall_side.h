#pragma once

#include <array>
#include <string_view>

#include "graph/arguments.h"

namespace dini {

/// On which side of a surface a wall is.
enum class WallSide { inside, both, outside };
template <>
struct ChoiceNames<WallSide> {
  static constexpr std::array<std::string_view, 3> names = {"inside", "both", "outside"};
};

}  // namespace dini

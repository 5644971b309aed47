#pragma once

// The enums that nodes offer as choices, with the words that stand for them in documents.

#include <array>
#include <string_view>

#include "algebra/kernels.h"
#include "geometry/surface.h"
#include "graph/arguments.h"

namespace dini {

template <>
struct ChoiceNames<Rule> {
  static constexpr std::array<std::string_view, 2> names = {"exact", "paper"};
};

template <>
struct ChoiceNames<kernels::WarpMethod> {
  static constexpr std::array<std::string_view, 2> names = {"sum_generators", "sum_displacements"};
};

template <>
struct ChoiceNames<AtInfinity> {
  static constexpr std::array<std::string_view, 2> names = {"clip", "fail"};
};

}  // namespace dini

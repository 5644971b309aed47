#pragma once

#include "graph/arguments.h"

namespace dini {

template <>
struct ChoiceNames<Quality> {
  static constexpr std::array names = {"draft", "final"};
};

}  // namespace dini

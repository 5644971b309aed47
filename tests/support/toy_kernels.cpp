// The part of the kernels that the command line touches, for programs built on the toy engine.

#include <array>
#include <span>
#include <string_view>

#include "algebra/kernels.h"

namespace dini::kernels {

std::span<const char* const> instruction_sets() {
  static constexpr std::array<const char*, 2> names = {"WIDE", "NARROW"};
  return names;
}

bool force_instruction_set(const char* name) {
  const std::string_view wanted = name;
  return wanted.empty() || wanted == "WIDE" || wanted == "NARROW";
}

const char* current_instruction_set() { return "WIDE"; }

}  // namespace dini::kernels

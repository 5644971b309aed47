#include "algebra/kernels.h"

#include <array>
#include <string_view>

#include "hwy/highway.h"

namespace dini::kernels {

namespace {

/// Every target compiled in that this processor runs, best first (Highway numbers the better ones lower).
struct Available {
  std::array<const char*, 64> names{};
  std::array<std::int64_t, 64> targets{};
  std::size_t count = 0;

  Available() {
    hwy::SetSupportedTargetsForTest(0);
    for (std::int64_t rest = hwy::SupportedTargets() & HWY_TARGETS; rest != 0; rest &= rest - 1) {
      targets[count] = rest & ~(rest - 1);
      names[count] = hwy::TargetName(targets[count]);
      ++count;
    }
  }
};

const Available& available() {
  static const Available result;
  return result;
}

}  // namespace

std::span<const char* const> instruction_sets() { return {available().names.data(), available().count}; }

bool force_instruction_set(const char* name) {
  const Available& all = available();
  std::int64_t target = 0;
  for (std::size_t i = 0; i < all.count; ++i) {
    if (std::string_view(all.names[i]) == name) target = all.targets[i];
  }
  if (target == 0 && *name != '\0') return false;
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return true;
}

const char* current_instruction_set() {
  const Available& all = available();
  const std::int64_t targets = hwy::SupportedTargets() & HWY_TARGETS;
  for (std::size_t i = 0; i < all.count; ++i) {
    if ((targets & all.targets[i]) != 0) return all.names[i];
  }
  return "";
}

}  // namespace dini::kernels

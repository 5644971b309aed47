#include "cli/testing/case_result.h"

namespace dini::cli {

std::string_view name_of(GoldenState state) {
  switch (state) {
    case GoldenState::none:
      return "not compared";
    case GoldenState::same:
      return "same";
    case GoldenState::within:
      return "same within tolerance";
    case GoldenState::changed:
      return "changed";
    case GoldenState::missing:
      return "no golden result";
    case GoldenState::updated:
      break;
  }
  return "golden result written";
}

Tally tally_of(const std::vector<CaseResult>& results) {
  Tally tally;
  for (const CaseResult& result : results) {
    ++(result.skipped ? tally.skipped : result.passed() ? tally.passed : tally.failed);
    tally.milliseconds += result.milliseconds;
  }
  return tally;
}

std::string text_of(const Tally& tally) {
  std::string text = std::to_string(tally.passed) + " passed";
  if (tally.failed > 0) text += ", " + std::to_string(tally.failed) + " failed";
  if (tally.skipped > 0) text += ", " + std::to_string(tally.skipped) + " skipped";
  return text;
}

}  // namespace dini::cli

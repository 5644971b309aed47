#include "cli/fitting/words.h"

#include <algorithm>
#include <optional>

#include "cli/number_in.h"
#include "cli/problems.h"

namespace dini::cli {
namespace {

/// `0.2:3`
std::optional<Json> bounds_in(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto low = number_in<double>(text.substr(0, colon)), high = number_in<double>(text.substr(colon + 1));
  if (!low || !high) return std::nullopt;
  return Json::array({*low, *high});
}

}  // namespace

void FitWords::add_options(CLI::App& command) {
  command
      .add_option("--vary", vary_,
                  "Parameters that may change, as NAME,NAME=LOWEST:HIGHEST,...; those without bounds keep within their "
                  "own. May be repeated")
      ->required()
      ->allow_extra_args(false);
  command
      .add_option("--target", targets_,
                  "The number wanted of a node, or node.output, as NODE.OUTPUT=NUMBER, or a list of all its numbers in "
                  "brackets; may be repeated")
      ->allow_extra_args(false);
}

Result<Json> FitWords::vary() const {
  Json vary = Json::object();
  for (const std::string& words : vary_) {
    std::size_t begin = 0;
    while (begin <= words.size()) {
      const std::size_t end = std::min(words.find(',', begin), words.size());
      const std::string word = words.substr(begin, end - begin);
      begin = end + 1;
      const std::size_t equals = word.find('=');
      const std::string name = word.substr(0, equals);
      std::optional<Json> bounds = Json::array();
      if (equals != std::string::npos) bounds = bounds_in(std::string_view(word).substr(equals + 1));
      if (name.empty() || !bounds) {
        return usage_problem("--vary takes NAME or NAME=LOWEST:HIGHEST, with commas between several, not '" + word +
                             "'");
      }
      if (vary.contains(name)) return usage_problem("--vary names '" + name + "' twice");
      vary[name] = *std::move(bounds);
    }
  }
  return vary;
}

Result<Json> FitWords::targets(const Limits& limits) const {
  Json targets = Json::object();
  for (const std::string& word : targets_) {
    const std::size_t equals = word.find('=');
    const bool is_pair = equals != std::string::npos && equals > 0 && equals + 1 < word.size();
    const auto value = is_pair ? parse_json(word.substr(equals + 1), limits) : Result<Json>(Json());
    if (!is_pair || !value || (!value->is_number() && !value->is_array())) {
      return usage_problem("--target takes NODE=NUMBER or NODE.OUTPUT=NUMBER, or a list in brackets, not '" + word +
                           "'");
    }
    const std::string place = word.substr(0, equals);
    if (targets.contains(place)) return usage_problem("--target names '" + place + "' twice");
    targets[place] = *value;
  }
  return targets;
}

}  // namespace dini::cli

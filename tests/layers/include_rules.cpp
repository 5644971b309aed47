#include "tests/layers/include_rules.h"

#include <algorithm>
#include <optional>
#include <sstream>

namespace dini::support {
namespace {

/// The path between the quotes or angle brackets of an include line.
struct Include {
  std::string_view path;
  bool quoted = false;
};

std::string_view without_leading_space(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  return text;
}

std::optional<Include> include_of(std::string_view line) {
  line = without_leading_space(line);
  if (!line.starts_with('#')) return std::nullopt;
  line = without_leading_space(line.substr(1));
  if (!line.starts_with("include")) return std::nullopt;
  line = without_leading_space(line.substr(std::string_view("include").size()));
  if (!line.starts_with('"') && !line.starts_with('<')) return std::nullopt;
  const bool quoted = line.front() == '"';
  line.remove_prefix(1);
  return Include{line.substr(0, line.find(quoted ? '"' : '>')), quoted};
}

bool is_project_folder(std::string_view folder) {
  const auto rules = layer_rules();
  return folder == "tests" || folder == "bench" ||
         std::any_of(rules.begin(), rules.end(), [&](const LayerRule& rule) { return rule.layer == folder; });
}

bool is_allowed(std::string_view path, const LayerRule& rule) {
  return std::any_of(rule.may_include.begin(), rule.may_include.end(), [&](std::string_view allowed) {
    return allowed.ends_with('/') ? path.starts_with(allowed) : path == allowed;
  });
}

std::string complaint(const Include& include, const LayerRule& rule) {
  const std::size_t slash = include.path.find('/');
  const std::string path(include.path);
  if (slash == std::string_view::npos) {
    return include.quoted ? "\"" + path + "\" does not start at the root of the project" : "";
  }
  const std::string_view folder = include.path.substr(0, slash);
  if (folder == rule.layer || !is_project_folder(folder) || is_allowed(include.path, rule)) return "";
  return "the layer " + std::string(rule.layer) + " may not include \"" + path + "\"";
}

}  // namespace

std::span<const LayerRule> layer_rules() {
  static const std::vector<LayerRule> rules = {
      {"algebra", {}},
      {"geometry", {"algebra/"}},
      {"draco", {}},
      {"gltf", {"draco/", "geometry/", "algebra/"}},
      {"formats", {"gltf/", "geometry/", "algebra/"}},
      {"graph", {"geometry/", "algebra/"}},
      {"golden", {"graph/", "gltf/", "geometry/", "algebra/"}},
      {"nodes", {"graph/", "formats/", "gltf/", "geometry/", "algebra/"}},
      {"service", {"nodes/", "graph/", "gltf/", "draco/", "geometry/", "algebra/"}},
      {"fitting", {"service/", "graph/", "gltf/", "geometry/", "algebra/"}},
      {"store", {"graph/"}},
      {"queue", {"graph/", "geometry/expected.h"}},
      {"jobs",
       {"store/", "queue/", "fitting/", "service/", "graph/problem.h", "graph/digest.h", "graph/job.h",
        "graph/stopped.h", "geometry/cancel.h", "geometry/large_memory.h"}},
      {"server",
       {"store/", "queue/", "jobs/", "fitting/", "service/", "graph/problem.h", "graph/limits.h", "graph/nearest.h",
        "graph/cache.h", "graph/digest.h", "graph/file.h", "geometry/cancel.h", "geometry/markup.h"}},
      {"cli",
       {"server/", "store/", "queue/", "jobs/", "fitting/", "service/", "golden/", "graph/problem.h", "graph/nearest.h",
        "graph/stopped.h", "geometry/cancel.h", "geometry/counted.h", "geometry/markup.h", "geometry/place_text.h",
        "algebra/kernels.h"}},
  };
  return rules;
}

std::vector<std::string> wrong_includes(const SourceFile& file, const LayerRule& rule) {
  std::vector<std::string> wrong;
  std::istringstream lines(file.text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    const std::optional<Include> include = include_of(line);
    if (!include) continue;
    const std::string text = complaint(*include, rule);
    if (!text.empty()) wrong.push_back(file.path + ":" + std::to_string(number) + ": " + text);
  }
  return wrong;
}

}  // namespace dini::support

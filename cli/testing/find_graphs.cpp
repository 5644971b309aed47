#include "cli/testing/find_graphs.h"

#include <algorithm>
#include <system_error>

#include "cli/output_files.h"
#include "cli/problems.h"
#include "cli/source_text.h"

namespace dini::cli {
namespace {

namespace fs = std::filesystem;

bool is_left_out(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return name.starts_with('.') || name == "golden" || name == "node_modules";
}

bool is_graph(const fs::path& path) {
  const std::string name = path.filename().string();
  if (!name.ends_with(".json") || name.ends_with(".cases.json") || name.ends_with(".golden.json")) return false;
  const auto source = read_source(path.string());
  if (!source) return true;  // which is told when it is tested
  const Json json = Json::parse(source->text, nullptr, false);
  return json.is_discarded() ? source->text.find("\"nodes\"") != std::string::npos : looks_like_graph(json);
}

Problems find_in(const fs::path& root, std::vector<FoundGraph>& found) {
  std::error_code error;
  fs::recursive_directory_iterator entry(root, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code unknown;
    if (entry->is_directory(unknown)) {
      if (is_left_out(entry->path())) entry.disable_recursion_pending();
    } else if (entry->is_regular_file(unknown) && is_graph(entry->path())) {
      found.push_back({entry->path().lexically_normal().string(), root});
    }
  }
  if (error) return {io_problem(root.string(), error.value())};
  return {};
}

}  // namespace

fs::path cases_path(const std::string& graph) { return fs::path(graph).replace_extension(".cases.json"); }

Result<std::vector<FoundGraph>> find_graphs(const std::vector<std::string>& paths) {
  std::vector<FoundGraph> found;
  for (const std::string& path : paths) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
      if (Problems wrong = find_in(path, found); !wrong.empty()) return wrong;
    } else {
      found.push_back({path, fs::path(path).parent_path()});
    }
  }
  std::ranges::stable_sort(found, {}, &FoundGraph::path);
  const auto repeated = std::ranges::unique(found, {}, &FoundGraph::path);
  found.erase(repeated.begin(), repeated.end());
  if (!found.empty()) return found;
  std::string list;
  for (const std::string& path : paths) list += (list.empty() ? "" : ", ") + path;
  return usage_problem("there is no graph in " + list);
}

}  // namespace dini::cli

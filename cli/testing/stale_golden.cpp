#include "cli/testing/stale_golden.h"

#include <algorithm>
#include <map>
#include <set>
#include <system_error>
#include <tuple>

#include "cli/exit_codes.h"

namespace dini::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view ending = ".golden.json";

std::string normal(const fs::path& path) { return path.lexically_normal().string(); }

/// A folder of golden results and that of the graphs that they are of.
struct Place {
  fs::path golden, graphs;

  bool operator<(const Place& other) const { return std::tie(golden, graphs) < std::tie(other.golden, other.graphs); }
};

/// What a golden result is called after: "ring.thin" of "ring.thin.golden.json"; empty for other files.
std::string base_of(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.size() > ending.size() && name.ends_with(ending) ? name.substr(0, name.size() - ending.size()) : "";
}

/// The name of the graph of a golden result, the longest for which there is one; empty when there is none.
std::string owner_of(const std::string& base, const fs::path& graphs) {
  std::error_code error;
  for (std::size_t end = base.size(); end != std::string::npos && end > 0; end = base.rfind('.', end - 1)) {
    if (fs::exists(graphs / (base.substr(0, end) + ".json"), error)) return base.substr(0, end);
  }
  return "";
}

CaseResult left_over(const std::string& graph, const std::string& case_name, const fs::path& path,
                     const std::string& why) {
  return {.graph = graph,
          .name = case_name.empty() ? "left over" : case_name,
          .code = exit_check_failed,
          .problems = {{.code = "golden-stale",
                        .detail = "the golden result " + path.string() + " is of " + why +
                                  "; --update-golden takes it away"}},
          .stale = {path.string()}};
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    if (!base_of(entry->path()).empty()) files.push_back(entry->path());
  }
  std::ranges::sort(files);
  return files;
}

/// A folder and all below it, but for those where graphs keep golden results of their own.
std::vector<fs::path> folders_of(const fs::path& folder) {
  std::vector<fs::path> folders = {folder};
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error); !error && entry != fs::recursive_directory_iterator();
       entry.increment(error)) {
    if (!entry->is_directory(error)) continue;
    if (entry->path().filename() == "golden") {
      entry.disable_recursion_pending();
    } else {
      folders.push_back(entry->path());
    }
  }
  std::ranges::sort(folders);
  return folders;
}

/// The golden results below a folder of --golden that are of no graph below the folders that were tested; none where a
/// graph was named by itself, for then the folder is that of others as well.
std::vector<CaseResult> of_no_graph(const fs::path& golden, const std::vector<std::string>& paths) {
  std::error_code error;
  if (!std::ranges::all_of(paths, [&](const std::string& path) { return fs::is_directory(path, error); })) return {};
  std::vector<CaseResult> stale;
  for (const fs::path& folder : folders_of(golden)) {
    const fs::path below = folder.lexically_relative(golden);
    for (const fs::path& file : files_in(folder)) {
      const std::string base = base_of(file);
      const auto has_graph = [&](const fs::path& root) { return !owner_of(base, root / below).empty(); };
      if (std::ranges::any_of(paths, has_graph)) continue;
      const std::string graph = (fs::path(paths.front()) / below / (base + ".json")).lexically_normal().string();
      stale.push_back(left_over(graph, "", file, "no graph in the folders that were tested"));
    }
  }
  return stale;
}

}  // namespace

std::vector<CaseResult> stale_golden(const GoldenOptions& options, const std::vector<TestGraph>& graphs,
                                     const std::vector<std::string>& paths) {
  std::map<std::string, const TestGraph*> tested;
  std::set<std::string> expected;
  std::map<Place, bool> places;  // and whether all graphs there were tested
  for (const TestGraph& graph : graphs) {
    const std::string& path = graph.found.path;
    tested[normal(path)] = &graph;
    const fs::path folder = golden_file(options, path, graph.found.root, "").path.parent_path();
    const bool is_named = std::ranges::find(paths, path) != paths.end();
    places[{folder, fs::path(path).parent_path()}] |= !is_named && !options.folder;  // else see `of_no_graph`
    for (const TestCase& each : graph.cases) {
      if (each.fails.empty()) expected.insert(normal(golden_file(options, path, graph.found.root, each.name).path));
    }
  }
  std::vector<CaseResult> stale;
  if (options.folder) stale = of_no_graph(*options.folder, paths);
  for (const auto& [place, is_whole] : places) {
    for (const fs::path& file : files_in(place.golden)) {
      if (expected.contains(normal(file))) continue;
      const std::string base = base_of(file), owner = owner_of(base, place.graphs);
      if (owner.empty()) {
        const std::string graph = (place.graphs / (base + ".json")).string();
        if (is_whole) stale.push_back(left_over(graph, "", file, "no graph that is here"));
        continue;
      }
      const std::string graph = (place.graphs / (owner + ".json")).string();
      const auto known = tested.find(normal(graph));
      if (known == tested.end() || !known->second->can_run()) continue;
      const std::string case_name = base.size() > owner.size() ? base.substr(owner.size() + 1) : "";
      const bool must_fail =
          std::ranges::find(known->second->cases, case_name, &TestCase::name) != known->second->cases.end();
      const std::string why =
          case_name.empty() ? "the graph without cases"
                            : "the case " + case_name + (must_fail ? ", which has to fail" : ", which is no more");
      stale.push_back(left_over(known->second->found.path, case_name, file, why));
    }
  }
  return stale;
}

}  // namespace dini::cli

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "graph/problem.h"

namespace dini::cli {

/// A graph to test, and the folder in which it was found; that of its file when it was named itself.
struct FoundGraph {
  std::string path;
  std::filesystem::path root;
};

/// The graphs that are named, and all in the folders that are named, by their paths. Graphs in a folder are its `.json`
/// files with the members `format` and `nodes`, and those that are not JSON but speak of `"nodes"`: a broken graph is
/// found too. Left out are cases, golden results, and folders called `golden`, `node_modules` or `.something`.
/// Problems: `io`, and `usage` when there is none at all.
Result<std::vector<FoundGraph>> find_graphs(const std::vector<std::string>& paths);

/// `ring.cases.json` beside `ring.json`.
std::filesystem::path cases_path(const std::string& graph);

}  // namespace dini::cli

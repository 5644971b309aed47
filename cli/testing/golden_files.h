#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "golden/golden_result.h"

namespace dini::cli {

/// Where golden results are, and what is done with them.
struct GoldenOptions {
  std::optional<std::string> folder;  ///< --golden; else a folder `golden` beside each graph, where there is one
  bool update = false;
  double tolerance = 1e-6;  ///< share of the largest extent
};

/// The file of the golden result of a case, and whether there has to be one. `root` is the folder that the graph was
/// found in: in a folder of all golden results they lie as the graphs do below it.
struct GoldenFile {
  std::filesystem::path path;
  bool is_expected = false;
};
GoldenFile golden_file(const GoldenOptions& options, const std::string& graph, const std::filesystem::path& root,
                       const std::string& case_name);

/// What a file holds; nothing when there is none. Problems: `io` and those of `read_golden`, with the path.
Result<std::optional<GoldenResult>> load_golden(const std::filesystem::path& path);

/// Writes it, and makes its folder. Problems: `io`.
Problems save_golden(const std::filesystem::path& path, const GoldenResult& result);

}  // namespace dini::cli

#include "cli/testing/golden_files.h"

#include <system_error>

#include "cli/documents.h"
#include "cli/output_files.h"

namespace dini::cli {
namespace fs = std::filesystem;

GoldenFile golden_file(const GoldenOptions& options, const std::string& graph, const fs::path& root,
                       const std::string& case_name) {
  const fs::path path(graph);
  const std::string name = path.stem().string() + (case_name.empty() ? "" : "." + case_name) + ".golden.json";
  if (options.folder) {
    const fs::path below = path.parent_path().lexically_relative(root.lexically_normal());
    return {fs::path(*options.folder) / (below.empty() ? fs::path() : below) / name, true};
  }
  std::error_code error;
  const fs::path beside = path.parent_path() / "golden";
  return {beside / name, fs::is_directory(beside, error)};
}

Result<std::optional<GoldenResult>> load_golden(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return std::optional<GoldenResult>();
  constexpr std::size_t most_bytes = std::size_t{64} << 20;
  const Result<std::string> text = read_input(path.string(), most_bytes);
  if (!text) return text.problems();
  Result<GoldenResult> read = read_golden(*text);
  if (read) return std::optional(*std::move(read));
  Problems problems = read.problems();
  for (Problem& problem : problems) problem.detail = path.string() + ": " + problem.detail;
  return problems;
}

Problems save_golden(const fs::path& path, const GoldenResult& result) {
  if (Problems wrong = make_folders({{"--update-golden", path.string()}}); !wrong.empty()) return wrong;
  return write_output(path.string(), write_golden(result));
}

}  // namespace dini::cli

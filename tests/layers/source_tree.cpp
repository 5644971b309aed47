#include "tests/layers/source_tree.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <string_view>

namespace dini::support {
namespace {

namespace fs = std::filesystem;

bool is_left_out(const fs::path& path) {
  static constexpr std::array<std::string_view, 5> names = {".git", "build", "node_modules", "dist",
                                                            "package-lock.json"};
  static constexpr std::array<std::string_view, 8> binary = {".png",  ".jpg", ".ico",  ".woff2",
                                                             ".wasm", ".glb", ".gltf", ".gz"};
  return std::find(names.begin(), names.end(), path.filename().string()) != names.end() ||
         std::find(binary.begin(), binary.end(), path.extension().string()) != binary.end();
}

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

std::vector<SourceFile> read_source_files(const fs::path& root, const std::string& folder) {
  std::vector<SourceFile> files;
  for (fs::recursive_directory_iterator entry(root / folder), end; entry != end; ++entry) {
    if (is_left_out(entry->path())) {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file()) {
      files.push_back({entry->path().lexically_relative(root).generic_string(), read_text(entry->path())});
    }
  }
  std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

}  // namespace dini::support

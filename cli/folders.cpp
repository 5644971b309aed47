#include "cli/folders.h"

namespace dini::cli {

std::filesystem::path find_folder(const std::string& given, const char* in_build_tree, const char* installed) {
  if (!given.empty()) return given;
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const auto* place : {in_build_tree, installed}) {
    auto folder = (program / place).lexically_normal();
    if (!error && std::filesystem::is_directory(folder, error)) return folder;
  }
  return {};
}

std::filesystem::path find_examples(const std::string& given) {
  return find_folder(given, "../../examples", "../share/dini/examples");
}

}  // namespace dini::cli

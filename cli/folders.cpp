#include "cli/folders.h"

#include <cstdlib>

namespace dini::cli {

std::filesystem::path find_folder(const std::string& given, const char* in_build_tree, const char* installed) {
  if (!given.empty()) return given;
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const auto* place : {in_build_tree, installed}) {
    auto folder = (program / place).lexically_normal();
    std::error_code none_there;
    if (!error && std::filesystem::is_directory(folder, none_there)) return folder;
  }
  return {};
}

std::filesystem::path find_examples(const std::string& given) {
  return find_folder(given, "../../examples", "../share/dini/examples");
}

std::filesystem::path data_folder(const std::string& given) {
  if (!given.empty()) return given;
  const auto variable = [](const char* name) -> std::filesystem::path {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
  };
  // What is relative there is to be taken for nothing (XDG Base Directory Specification).
  if (const auto data = variable("XDG_DATA_HOME"); data.is_absolute()) return data / "dini";
  const auto home = variable("HOME");
  return home.is_absolute() ? home / ".local/share/dini" : std::filesystem::path();
}

}  // namespace dini::cli

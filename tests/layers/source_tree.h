#pragma once

// The files of the project as the tests of its own order see them.

#include <filesystem>
#include <string>
#include <vector>

namespace dini::support {

/// One file: its path from the root of the project, with forward slashes, and its text.
struct SourceFile {
  std::string path;
  std::string text;
};

/// Every file below `folder` (empty for the whole project), sorted by path. What is not written by hand is left out:
/// builds, installed packages, lock files, pictures, and everything that git keeps.
std::vector<SourceFile> read_source_files(const std::filesystem::path& root, const std::string& folder);

}  // namespace dini::support

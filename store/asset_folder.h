#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "graph/digest.h"
#include "graph/file.h"
#include "graph/problem.h"

namespace dini::store {

/// A file of the folder, as its name and its entry tell it.
struct AssetEntry {
  Digest sha256{};
  std::uintmax_t bytes = 0;
  std::int64_t used = 0;  ///< nanoseconds since 1970
};

/// Files that are called by the hash of their bytes, in `assets` of a data folder. A file is there whole or not at all,
/// and what is not what its name says is taken for missing. The time of a file is that of its last use.
class AssetFolder {
 public:
  explicit AssetFolder(const std::filesystem::path& data_folder) : path_(data_folder / "assets") {}

  const std::filesystem::path& path() const { return path_; }

  /// Writes a file through to the disk. Problems: `storage-full`, `storage-failed`.
  Result<bool> write(const Digest& sha256, std::string_view bytes) const;
  /// The bytes of a file; null when it is missing or damaged.
  SharedBytes read(const Digest& sha256) const;
  /// Whether there is a file of that name, be it damaged.
  bool has(const Digest& sha256) const;
  void remove(const Digest& sha256) const;
  /// Makes now the time of its last use; nothing happens when it is missing.
  void touch(const Digest& sha256) const;

  /// Every file, damaged ones too; empty without a folder.
  std::vector<AssetEntry> entries() const;
  /// Removes what a process left that ended while it wrote.
  void remove_unfinished() const;

 private:
  std::filesystem::path file(const Digest& sha256) const { return path_ / to_hex(sha256); }

  std::filesystem::path path_;
};

/// What is wrong with the files of a data folder, in words; empty when nothing is. Reads everything.
std::string fault_in_assets(const std::filesystem::path& data_folder);

/// Copies the files into a new folder and writes them through to the disk. Problems (`io`): the first that is damaged,
/// after all others are copied, or one that cannot be written.
Result<std::size_t> copy_assets(const std::filesystem::path& data_folder, const std::filesystem::path& target);

}  // namespace dini::store

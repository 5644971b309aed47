#include "store/asset_files.h"

#include <algorithm>
#include <utility>

namespace dini::store {

AssetFiles::AssetFiles(const std::filesystem::path& data_folder, std::size_t most_bytes, IsNamed is_named)
    : folder_(data_folder), most_bytes_(most_bytes), is_named_(std::move(is_named)) {
  folder_.remove_unfinished();
}

Result<bool> AssetFiles::keep(const Digest& sha256, std::string_view bytes) {
  const std::lock_guard lock(writing_);
  // One that is damaged is written anew.
  if (folder_.read(sha256) != nullptr) {
    folder_.touch(sha256);
    return true;
  }
  if (auto room = make_room(sha256, bytes.size()); !room) return room;
  return folder_.write(sha256, bytes);
}

SharedBytes AssetFiles::find(const Digest& sha256) {
  SharedBytes bytes = folder_.read(sha256);
  if (bytes != nullptr) folder_.touch(sha256);
  return bytes;
}

Result<bool> AssetFiles::make_room(const Digest& sha256, std::size_t bytes) {
  std::vector<AssetEntry> entries = folder_.entries();
  std::erase_if(entries, [&](const AssetEntry& entry) { return entry.sha256 == sha256; });
  std::ranges::sort(entries, {}, &AssetEntry::used);
  std::uintmax_t total = bytes;
  for (const AssetEntry& entry : entries) total += entry.bytes;
  // Nothing goes before it is known that this is enough.
  std::vector<Digest> going;
  for (const AssetEntry& entry : entries) {
    if (total <= most_bytes_) break;
    if (is_named_(entry.sha256)) continue;
    total -= entry.bytes;
    going.push_back(entry.sha256);
  }
  if (total > most_bytes_) {
    return Problem{.code = "storage-full",
                   .detail = "There is no room to keep this file: uploaded files may have " +
                             std::to_string(most_bytes_) +
                             " bytes together (`asset_file_bytes`), and stored graphs name the others."};
  }
  for (const Digest& gone : going) folder_.remove(gone);
  return true;
}

}  // namespace dini::store

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <mutex>

#include "graph/asset_keeper.h"
#include "store/asset_folder.h"

namespace dini::store {

/// The uploaded files of a data folder, which this process alone writes. Together they are held within a size: those
/// that were used longest ago go first, but none that a stored graph names.
class AssetFiles final : public AssetKeeper {
 public:
  /// Whether a stored graph names a file. In doubt it does.
  using IsNamed = std::function<bool(const Digest& sha256)>;

  AssetFiles(const std::filesystem::path& data_folder, std::size_t most_bytes, IsNamed is_named);

  Result<bool> keep(const Digest& sha256, std::string_view bytes) override;
  SharedBytes find(const Digest& sha256) override;
  void note_use(const Digest& sha256) override { folder_.touch(sha256); }

 private:
  Result<bool> make_room(const Digest& sha256, std::size_t bytes);

  AssetFolder folder_;
  std::size_t most_bytes_;
  IsNamed is_named_;
  std::mutex writing_;
};

}  // namespace dini::store

#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "geometry/cancel.h"
#include "graph/asset_file.h"
#include "graph/asset_keeper.h"
#include "graph/limits.h"
#include "graph/problem.h"
#include "service/asset_store.h"

namespace dini {

/// The files that graphs may name: their meshes in memory, and the files themselves with a keeper if there is one. What
/// memory has let go of, or another process was given, is read again from there. Safe to use from many threads.
class AssetLibrary {
 public:
  explicit AssetLibrary(const Limits& limits) : limits_(limits), meshes_(limits.asset_store_bytes) {}

  /// From now on files without a name are kept there; null: in memory only.
  void keep_in(std::shared_ptr<AssetKeeper> keeper);

  /// Reads a file and makes it known. Problems: those of `read_asset`, and of the keeper for a file without a name.
  Result<SharedAssetFile> add(std::string_view bytes, const std::string& name, const Cancel& cancel);

  /// By 64 hexadecimal digits or a name; null if it is not here.
  SharedAssetFile find(std::string_view text, const Cancel& cancel);

  /// The bytes of a file by 64 hexadecimal digits; null if it is not here.
  SharedBytes bytes(std::string_view sha256);

 private:
  std::shared_ptr<AssetKeeper> keeper();

  const Limits& limits_;
  AssetStore meshes_;
  std::mutex mutex_;
  std::shared_ptr<AssetKeeper> keeper_;
  std::mutex reading_;  ///< one file is read again at a time, which bounds the memory that this takes
};

}  // namespace dini

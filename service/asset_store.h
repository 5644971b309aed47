#pragma once

#include <list>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

#include "graph/asset_file.h"

namespace dini {

/// The mesh files that graphs may name, by content hash and, for files that were given a name, by that too. Files
/// without a name share a budget of memory; the least recently used go first. A plan keeps the files that it uses, so
/// none is taken from under an evaluation. Safe to use from many threads.
class AssetStore {
 public:
  explicit AssetStore(std::size_t budget) : budget_(budget) {}

  /// 1 to 64 letters, digits, `_`, `-` and `.`; not what could be a hash.
  static bool is_name(std::string_view text);

  /// An empty name: none. A name that is there already means the new file from now on.
  void add(SharedAssetFile file, const std::string& name);

  /// By 64 hexadecimal digits or a name; null if it is not here. Counts as a use.
  SharedAssetFile find(std::string_view text);

 private:
  const std::size_t budget_;
  std::mutex mutex_;
  std::list<SharedAssetFile> unnamed_;  ///< most recently used first
  std::map<std::string, std::list<SharedAssetFile>::iterator, std::less<>> by_hash_;
  std::map<std::string, SharedAssetFile, std::less<>> named_;  ///< by name and by hash
  std::size_t bytes_ = 0;                                      ///< of the unnamed
};

}  // namespace dini

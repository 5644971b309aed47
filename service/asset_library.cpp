#include "service/asset_library.h"

#include <utility>

#include "service/asset_reader.h"

namespace dini {

void AssetLibrary::keep_in(std::shared_ptr<AssetKeeper> keeper) {
  const std::lock_guard lock(mutex_);
  keeper_ = std::move(keeper);
}

std::shared_ptr<AssetKeeper> AssetLibrary::keeper() {
  const std::lock_guard lock(mutex_);
  return keeper_;
}

Result<SharedAssetFile> AssetLibrary::add(std::string_view bytes, const std::string& name, const Cancel& cancel) {
  Result<std::shared_ptr<AssetFile>> read = read_asset(bytes, limits_, cancel);
  if (!read) return read.problems();
  const std::shared_ptr<AssetKeeper> keeper = name.empty() ? this->keeper() : nullptr;
  if (keeper == nullptr) {
    (*read)->source = share(std::string(bytes));
  } else if (auto kept = keeper->keep((*read)->sha256, bytes); !kept) {
    return kept.problems();
  }
  meshes_.add(*read, name);
  return SharedAssetFile(*std::move(read));
}

SharedAssetFile AssetLibrary::find(std::string_view text, const Cancel& cancel) {
  const std::shared_ptr<AssetKeeper> keeper = this->keeper();
  if (SharedAssetFile known = meshes_.find(text)) {
    if (keeper != nullptr && known->source == nullptr) keeper->note_use(known->sha256);
    return known;
  }
  const std::optional<Digest> digest = digest_from_hex(text);
  if (keeper == nullptr || !digest) return nullptr;
  const std::lock_guard lock(reading_);
  if (SharedAssetFile known = meshes_.find(text)) return known;
  const SharedBytes bytes = keeper->find(*digest);
  if (bytes == nullptr) return nullptr;
  Result<std::shared_ptr<AssetFile>> read = read_asset(*bytes, limits_, cancel);
  if (!read) return nullptr;
  meshes_.add(*read, "");
  return *std::move(read);
}

SharedBytes AssetLibrary::bytes(std::string_view sha256) {
  const std::optional<Digest> digest = digest_from_hex(sha256);
  if (!digest) return nullptr;
  if (const std::shared_ptr<AssetKeeper> keeper = this->keeper()) {
    if (SharedBytes kept = keeper->find(*digest)) return kept;
  }
  const SharedAssetFile known = meshes_.find(sha256);
  return known != nullptr ? known->source : nullptr;
}

}  // namespace dini

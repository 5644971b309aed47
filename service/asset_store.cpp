#include "service/asset_store.h"

#include <algorithm>

namespace dini {

namespace {

bool is_hexadecimal(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

bool is_hash(std::string_view text) {
  return text.size() == 64 && std::all_of(text.begin(), text.end(), is_hexadecimal);
}

std::size_t memory_of(const AssetFile& file) {
  return sizeof(AssetFile) + file.content.mesh.bytes() + (file.source ? file.source->size() : 0);
}

}  // namespace

bool AssetStore::is_name(std::string_view text) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == '.';
  };
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), fits) && !is_hash(text);
}

void AssetStore::add(SharedAssetFile file, const std::string& name) {
  const std::string hash = to_hex(file->sha256);
  const std::lock_guard lock(mutex_);
  if (!name.empty()) {
    named_[name] = file;
    named_[hash] = std::move(file);
    return;
  }
  if (const auto known = by_hash_.find(hash); known != by_hash_.end()) {
    unnamed_.splice(unnamed_.begin(), unnamed_, known->second);
    return;
  }
  bytes_ += memory_of(*file);
  unnamed_.push_front(std::move(file));
  by_hash_[hash] = unnamed_.begin();
  // The newest stays even when it is larger than the whole budget: its uploader is about to use it.
  while (bytes_ > budget_ && unnamed_.size() > 1) {
    bytes_ -= memory_of(*unnamed_.back());
    by_hash_.erase(to_hex(unnamed_.back()->sha256));
    unnamed_.pop_back();
  }
}

SharedAssetFile AssetStore::find(std::string_view text) {
  const std::lock_guard lock(mutex_);
  if (const auto found = named_.find(text); found != named_.end()) return found->second;
  const auto found = by_hash_.find(text);
  if (found == by_hash_.end()) return nullptr;
  unnamed_.splice(unnamed_.begin(), unnamed_, found->second);
  return *found->second;
}

}  // namespace dini

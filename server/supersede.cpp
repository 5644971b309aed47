#include "server/supersede.h"

#include <utility>

namespace dini::server {

Supersede::Entry::Entry(Supersede& registry, std::string key, const Cancel& cancel)
    : registry_(registry), key_(std::move(key)), cancel_(cancel) {
  if (key_.empty()) return;
  const std::lock_guard lock(registry_.mutex_);
  const auto [place, first] = registry_.newest_.try_emplace(key_, &cancel_);
  if (!first) std::exchange(place->second, &cancel_)->stop(StopReason::superseded);
}

Supersede::Entry::~Entry() {
  if (key_.empty()) return;
  const std::lock_guard lock(registry_.mutex_);
  const auto place = registry_.newest_.find(key_);
  if (place != registry_.newest_.end() && place->second == &cancel_) registry_.newest_.erase(place);
}

}  // namespace dini::server

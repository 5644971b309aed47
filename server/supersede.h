#pragma once

#include <map>
#include <mutex>
#include <string>

#include "geometry/cancel.h"

namespace dini::server {

/// The newest request of every `Supersede-Key`. While a slider is dragged each request makes the one before it
/// pointless; the older one is stopped inside its kernels instead of being finished for nobody.
class Supersede {
 public:
  /// One request, from here to the end of its scope: stops the one before it. An empty key takes no part.
  class Entry {
   public:
    Entry(Supersede& registry, std::string key, const Cancel& cancel);
    ~Entry();
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;

   private:
    Supersede& registry_;
    std::string key_;
    const Cancel& cancel_;
  };

 private:
  std::mutex mutex_;
  std::map<std::string, const Cancel*> newest_;
};

}  // namespace dini::server

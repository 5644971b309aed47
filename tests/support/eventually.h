#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace dini::support {

/// Waits up to fifteen seconds for something that another thread brings about.
inline bool eventually(const std::function<bool()>& holds) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(15);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace dini::support

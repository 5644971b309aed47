#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace dini::cli {

/// `120/200, 34 s left` on one line of standard error that is written over; nothing where that is no terminal.
class Progress {
 public:
  Progress(std::size_t total, bool wanted);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more is done; what is left is foretold by the time since the beginning.
  void step();

  /// Takes the line away, so that others can be written.
  void clear();

 private:
  const std::size_t total_;
  const bool shown_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::size_t done_ = 0;
};

}  // namespace dini::cli

#include "cli/sweeping/progress.h"

#include <cmath>
#include <iostream>
#include <unistd.h>

namespace dini::cli {

Progress::Progress(std::size_t total, bool wanted) : total_(total), shown_(wanted && ::isatty(STDERR_FILENO) != 0) {}

void Progress::step() {
  ++done_;
  if (!shown_) return;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  const double left = seconds / static_cast<double>(done_) * static_cast<double>(total_ - done_);
  std::cerr << "\r\x1b[K" << done_ << "/" << total_ << ", " << static_cast<long long>(std::ceil(left)) << " s left"
            << std::flush;
}

void Progress::clear() {
  if (shown_) std::cerr << "\r\x1b[K" << std::flush;
}

}  // namespace dini::cli

#include "cli/log_sink.h"

#include <mutex>
#include <poll.h>
#include <spdlog/sinks/base_sink.h>
#include <string>
#include <unistd.h>

namespace dini::cli {
namespace {

class LogSink final : public spdlog::sinks::base_sink<std::mutex> {
 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    if (lost_ > 0) {
      const std::string said = std::to_string(lost_) + " lines of the log were lost";
      if (write({"dini", spdlog::level::warn, said})) lost_ = 0;
    }
    if (!write(message)) ++lost_;
  }
  void flush_() override {}

 private:
  bool write(const spdlog::details::log_msg& message) {
    spdlog::memory_buf_t line;
    formatter_->format(message, line);
    return write_at_once(STDERR_FILENO, {line.data(), line.size()});
  }

  std::size_t lost_ = 0;
};

}  // namespace

bool write_at_once(int descriptor, std::string_view text) {
  // A pipe that can be written to takes so much without waiting.
  constexpr std::size_t most_bytes = 4096;
  pollfd state{descriptor, POLLOUT, 0};
  if (::poll(&state, 1, 0) != 1 || (state.revents & POLLOUT) == 0) return false;
  return ::write(descriptor, text.data(), std::min(text.size(), most_bytes)) > 0;
}

std::shared_ptr<spdlog::sinks::sink> log_sink() { return std::make_shared<LogSink>(); }

}  // namespace dini::cli

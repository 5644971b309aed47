#include "cli/json_lines.h"

#include <chrono>

#include "server/request_log.h"
#include "server/text.h"
#include "service/engine.h"

namespace dini::cli {
namespace {

/// So that the line with all its escapes is written at once, and so whole.
constexpr std::size_t most_message_bytes = 600;

class JsonLines final : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& line) override {
    const auto level = spdlog::level::to_string_view(message.level);
    const std::string_view said(message.payload.data(), message.payload.size());
    const auto since = std::chrono::duration_cast<std::chrono::milliseconds>(message.time.time_since_epoch());
    std::string text = R"({"time":")" + server::time_text(since.count()) + R"(","level":")";
    text.append(level.data(), level.size()).append("\",");
    if (std::string_view(message.logger_name.data(), message.logger_name.size()) == server::request_logger) {
      text += said;
    } else {
      text += "\"message\":" + dump(Json(said.substr(0, most_message_bytes)));
    }
    text += "}\n";
    line.append(text.data(), text.data() + text.size());
  }
  std::unique_ptr<spdlog::formatter> clone() const override { return std::make_unique<JsonLines>(); }
};

}  // namespace

std::unique_ptr<spdlog::formatter> json_lines() { return std::make_unique<JsonLines>(); }

}  // namespace dini::cli

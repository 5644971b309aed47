#pragma once

#include <memory>
#include <spdlog/sinks/sink.h>
#include <string_view>

namespace dini::cli {

/// Writes to a descriptor what it takes at once, at most 4096 bytes; false when it takes nothing now. Never waits: a
/// pipe whose reader is stuck must not stop a server.
bool write_at_once(int descriptor, std::string_view text);

/// Writes log lines to standard error as `write_at_once` does. Lines that are not taken are counted, and the count is
/// told once lines are taken again.
std::shared_ptr<spdlog::sinks::sink> log_sink();

}  // namespace dini::cli

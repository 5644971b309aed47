#pragma once

#include <catch2/catch.hpp>
#include <fstream>
#include <functional>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "server/server.h"
#include "tests/server/client.h"
#include "tests/support/eventually.h"
#include "tests/support/folder.h"
#include "tests/support/toy_engine.h"

namespace dini::support {

/// Settings whose deadlines are short enough to be waited for.
inline server::Settings quick_settings() {
  server::Settings settings;
  settings.port = 0;
  settings.head_deadline = std::chrono::milliseconds(500);
  settings.body_deadline = std::chrono::milliseconds(500);
  settings.compute_slots = 1;
  settings.compute_queue = 1;
  return settings;
}

/// Keeps the lines of a log.
class LogKeeper final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  std::string text() {
    const std::lock_guard lock(mutex_);
    return text_;
  }

 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t line;
    formatter_->format(message, line);
    text_.append(line.data(), line.size());
  }
  void flush_() override {}

  std::string text_;
};

/// A server on a free port; its log is kept for the tests.
class RunningOver {
 public:
  RunningOver(std::unique_ptr<Engine> engine, const server::Settings& settings) : engine_(std::move(engine)) {
    spdlog::drop_all();
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("test", log_));
    auto started = server::Server::start(*engine_, settings);
    REQUIRE(started);
    server_ = *std::move(started);
  }
  ~RunningOver() { stop(); }

  int port() const { return server_->port(); }
  void stop() {
    server_.reset();
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("none"));
  }
  std::string log() const { return log_->text(); }

 private:
  std::shared_ptr<LogKeeper> log_ = std::make_shared<LogKeeper>();
  std::unique_ptr<Engine> engine_;
  std::unique_ptr<server::Server> server_;
};

/// A server over the toy engine.
class Running : public RunningOver {
 public:
  explicit Running(const server::Settings& settings = quick_settings(), const Limits& limits = {})
      : RunningOver(std::make_unique<toy::ToyEngine>(limits), settings) {}
};

/// A server over the real engine.
class RunningReal : public RunningOver {
 public:
  explicit RunningReal(const server::Settings& settings = quick_settings(), const Limits& limits = {})
      : RunningOver(make_engine(limits), settings) {}
};

/// A number that the system tells about this process.
inline long process_status(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(name + ":")) return std::stol(line.substr(name.size() + 1));
  }
  return 0;
}

/// The memory this process holds now, in KiB.
inline long resident_kib() { return process_status("VmRSS"); }

inline std::size_t thread_count() { return static_cast<std::size_t>(process_status("Threads")); }

}  // namespace dini::support

#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <functional>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>
#include <sstream>
#include <thread>
#include <unistd.h>

#include "server/server.h"
#include "tests/server/client.h"
#include "tests/support/toy_engine.h"

namespace dini::testing {

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

/// A server on a free port over the toy engine; its log is kept for the tests.
class Running {
 public:
  explicit Running(const server::Settings& settings = quick_settings(), Limits limits = {}) : engine_(limits) {
    spdlog::drop_all();
    spdlog::set_default_logger(
        std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(log_, true)));
    auto started = server::Server::start(engine_, settings);
    REQUIRE(started);
    server_ = *std::move(started);
  }
  ~Running() { stop(); }

  int port() const { return server_->port(); }
  void stop() {
    server_.reset();
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("none"));
  }
  /// After `stop` only.
  std::string log() const { return log_.str(); }

 private:
  std::ostringstream log_;
  Engine engine_;
  std::unique_ptr<server::Server> server_;
};

/// A folder that is gone at the end.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("dini-test-" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << bytes;
  }

 private:
  std::filesystem::path path_;
};

/// Waits up to fifteen seconds for something that another thread brings about.
inline bool eventually(const std::function<bool()>& holds) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(15);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

/// The memory this process holds now, in KiB.
inline long resident_kib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) return std::stol(line.substr(6));
  }
  return 0;
}

}  // namespace dini::testing

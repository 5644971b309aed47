#pragma once

#include <arpa/inet.h>
#include <catch2/catch.hpp>
#include <csignal>
#include <memory>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "queue/connection.h"
#include "tests/cli/program.h"
#include "tests/support/eventually.h"
#include "tests/support/folder.h"

namespace dini::support {

/// A port of this machine that nobody listens on at this moment.
inline int free_port() {
  const int descriptor = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  REQUIRE(::bind(descriptor, reinterpret_cast<sockaddr*>(&address), size) == 0);
  REQUIRE(::getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size) == 0);
  ::close(descriptor);
  return ntohs(address.sin_port);
}

/// A Redis of its own, with its files in a folder of its own.
class RedisServer {
 public:
  explicit RedisServer(std::vector<std::string> options = {}) : options_(std::move(options)), port_(free_port()) {
    start();
  }

  int port() const { return port_; }
  queue::Address address() const { return {.port = port_}; }
  std::string url() const { return "redis://127.0.0.1:" + std::to_string(port_); }

  /// Begins, again perhaps, and returns once it answers.
  void start() {
    std::vector<std::string> words = {
        "/usr/bin/redis-server", "--port", std::to_string(port_), "--bind", "127.0.0.1", "--save", "", "--dir",
        folder_.path().string()};
    words.insert(words.end(), options_.begin(), options_.end());
    program_ = std::make_unique<Program>(words);
    REQUIRE(eventually([&] {
      const auto answered = queue::Connection(address(), {}).call({"PING"});
      return answered || answered.error().kind == queue::Fault::Kind::denied;
    }));
  }
  /// Ends at once, as when the machine fails.
  void end() { program_ = nullptr; }
  void signal(int number) const { program_->signal(number); }

  /// What it answers to a command of the test.
  queue::Reply call(const std::vector<std::string>& words) const {
    queue::Connection connection(address(), {std::chrono::seconds(5), std::chrono::seconds(5)});
    const auto answered = connection.call(words);
    REQUIRE(answered);
    return *answered;
  }

 private:
  const std::vector<std::string> options_;
  const int port_;
  const Folder folder_{"-redis"};
  std::unique_ptr<Program> program_;
};

}  // namespace dini::support

#pragma once

// Real servers and workers around a real Redis.

#include <csignal>
#include <list>

#include "tests/cli/serving.h"
#include "tests/server/client.h"
#include "tests/support/redis_server.h"

namespace dini::support {

/// The program over the toy engine; the build says where it is.
inline const std::string toy_program = DINI_TOY;

/// A worker that others take for lost after three seconds.
class WorkingProgram {
 public:
  explicit WorkingProgram(const std::string& program, const std::string& url,
                          const std::vector<std::string>& options = {"--threads", "1"})
      : program_(words(program, url, options)) {}

  void signal(int number) const { program_.signal(number); }
  Outcome wait() { return program_.wait(); }

 private:
  static std::vector<std::string> words(const std::string& program, const std::string& url,
                                        const std::vector<std::string>& options) {
    std::vector<std::string> all = {program, "worker", "--queue", url, "--silent-milliseconds", "3000"};
    all.insert(all.end(), options.begin(), options.end());
    return all;
  }

  Program program_;
};

/// One Redis, one server that gives it sweeps, some workers.
class Fleet {
 public:
  Fleet(std::string program, int workers, const std::vector<std::string>& options = {})
      : program_(std::move(program)), serving_(with_queue(options), program_) {
    for (int i = 0; i < workers; ++i) add_worker();
    REQUIRE(eventually([&] { return live_workers() >= workers; }));
  }

  RedisServer& redis() { return redis_; }
  int port() const { return serving_.port(); }
  Program& server() { return serving_.program(); }
  std::list<WorkingProgram>& workers() { return workers_; }
  void add_worker(const std::vector<std::string>& options = {"--threads", "1"}) {
    workers_.emplace_back(program_, redis_.url(), options);
  }

  /// A number of `GET /metrics`; 0 where it is not told.
  double metric(const std::string& name) const {
    const auto answer = get(port(), "/metrics");
    REQUIRE(answer);
    const auto place = answer->body.find("\n" + name + " ");
    return place == std::string::npos ? 0 : std::stod(answer->body.substr(place + name.size() + 2));
  }
  int live_workers() const { return static_cast<int>(metric("dini_queue_workers")); }
  /// Whether the server says that all of it works.
  bool is_whole() const {
    const auto answer = get(port(), "/readyz");
    return answer && answer->status == 200 && !answer->json().contains("degraded");
  }

 private:
  std::vector<std::string> with_queue(std::vector<std::string> options) const {
    options.insert(options.end(), {"--queue", redis_.url()});
    return options;
  }

  const std::string program_;
  RedisServer redis_;
  ServingProgram serving_;
  std::list<WorkingProgram> workers_;
};

/// A sweep of the toy: so many variants of so long each.
inline Json toy_sweep(std::size_t count, int milliseconds) {
  Json body = {{"graph",
                {{"format", 1},
                 {"parameters", {{"reach", Json::object()}, {"fatal", Json::object()}}},
                 {"nodes", {{"out", {{"type", "toy"}, {"inputs", {{"milliseconds", milliseconds}}}}}}}}}};
  for (std::size_t i = 0; i < count; ++i) body["grid"]["reach"].push_back(i);
  return body;
}

}  // namespace dini::support

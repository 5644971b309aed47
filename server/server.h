#pragma once

#include <memory>

#include "server/settings.h"
#include "service/engine.h"

namespace dini::server {

/// The HTTP server over an engine: loads the page and the examples, listens, and stops without losing a request.
class Server {
 public:
  /// Problems: a bad example or page (`bad-example`, `io`), a data folder (`io`), an address that cannot be had
  /// (`address`), or a machine that gives no memory or threads (`out-of-memory`).
  static Result<std::unique_ptr<Server>> start(const Engine& engine, const Settings& settings);

  /// Stops as `stop` does.
  ~Server();

  /// The port listened on.
  int port() const;

  /// Takes no new connections, lets running requests finish until the drain deadline, stops them then, and returns when
  /// every connection is closed.
  void stop();

 private:
  struct State;
  explicit Server(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace dini::server

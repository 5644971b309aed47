#pragma once

#include <string>

namespace dini::server {

/// A listening socket.
class Listener {
 public:
  Listener() = default;
  ~Listener() { close(); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  /// Listens on a host name or address and a port, 0 for a free one. The port, or 0 when the address cannot be had.
  int listen(const std::string& host, int port);

  int descriptor() const { return descriptor_; }

  /// A connection that has been made, non-blocking; -1 when there is none, with errno as `accept` sets it.
  int accept() const;

  /// Connections that were not accepted are reset.
  void close();

 private:
  int descriptor_ = -1;
};

}  // namespace dini::server

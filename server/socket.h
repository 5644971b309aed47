#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace dini::server {

/// A connected, non-blocking socket, owned. Nothing here waits.
class Socket {
 public:
  explicit Socket(int descriptor) : descriptor_(descriptor) {}
  ~Socket() { close(); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  void close();

  enum class Outcome { moved, would_wait, ended };
  struct Moved {
    Outcome outcome = Outcome::ended;
    std::size_t bytes = 0;
  };

  /// Reads what there is. `ended` when the peer sends nothing more or the connection is broken.
  Moved read(std::span<char> into) const;

  /// Sends what fits into the socket's buffer of a few pieces, at most sixteen. `ended` when the connection is broken.
  Moved write(std::span<const std::string_view> pieces) const;

  /// Says that nothing more will be sent.
  void finish_writing() const;

 private:
  int descriptor_;
};

}  // namespace dini::server

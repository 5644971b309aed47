#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

namespace dini::server {

/// A connected, non-blocking socket, owned. Every wait has an absolute deadline, so no peer can hold a thread by
/// dripping.
class Socket {
 public:
  using Clock = std::chrono::steady_clock;
  enum class Wait { ready, late, interrupted };

  explicit Socket(int descriptor) : descriptor_(descriptor) {}
  ~Socket();
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  int descriptor() const { return descriptor_; }

  /// Waits until something can be read (or the peer has left), the deadline passes, or `interrupt` becomes readable.
  Wait wait_readable(Clock::time_point deadline, int interrupt = -1) const;

  /// The number of bytes read; 0 when the peer has left or nothing came in time.
  std::size_t read(char* into, std::size_t size, Clock::time_point deadline) const;

  /// False when the peer has left or did not take everything in time.
  bool write(std::string_view bytes, Clock::time_point deadline) const;

  /// Says that nothing more will be sent, then swallows what the peer is still sending, for a moment: closing a socket
  /// with unread bytes would reset the connection and take the answer just given with it.
  void linger() const;

 private:
  int descriptor_;
};

}  // namespace dini::server

#include "server/socket.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace dini::server {
namespace {

constexpr std::chrono::milliseconds linger_time{500};

/// Milliseconds to a deadline for poll(): rounded up, so that a wait never ends just before it.
int remaining(Socket::Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Socket::Clock::now()).count();
  return static_cast<int>(std::clamp<decltype(left)>(left, 0, 60'000));
}

}  // namespace

Socket::~Socket() { ::close(descriptor_); }

Socket::Wait Socket::wait_readable(Clock::time_point deadline, int interrupt) const {
  std::array<pollfd, 2> waits = {pollfd{descriptor_, POLLIN, 0}, pollfd{interrupt, POLLIN, 0}};
  while (true) {
    const int count = ::poll(waits.data(), interrupt < 0 ? 1 : 2, remaining(deadline));
    if (count < 0 && errno != EINTR) return Wait::late;
    if (count > 0) return waits[0].revents != 0 ? Wait::ready : Wait::interrupted;
    if (Clock::now() >= deadline) return Wait::late;
  }
}

std::size_t Socket::read(char* into, std::size_t size, Clock::time_point deadline) const {
  while (true) {
    const ssize_t count = ::recv(descriptor_, into, size, 0);
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno == EINTR) continue;
    if (errno != EAGAIN && errno != EWOULDBLOCK) return 0;
    if (wait_readable(deadline) != Wait::ready) return 0;
  }
}

bool Socket::write(std::string_view bytes, Clock::time_point deadline) const {
  while (!bytes.empty()) {
    const ssize_t count = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
      continue;
    }
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK) return false;
    pollfd wait{descriptor_, POLLOUT, 0};
    if (Clock::now() >= deadline || (::poll(&wait, 1, remaining(deadline)) < 0 && errno != EINTR)) return false;
  }
  return true;
}

void Socket::linger() const {
  ::shutdown(descriptor_, SHUT_WR);
  const auto deadline = Clock::now() + linger_time;
  std::array<char, 4096> swallowed{};
  while (Clock::now() < deadline && read(swallowed.data(), swallowed.size(), deadline) > 0) continue;
}

}  // namespace dini::server

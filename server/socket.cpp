#include "server/socket.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

namespace dini::server {
namespace {

Socket::Moved moved(ssize_t count) {
  if (count > 0) return {Socket::Outcome::moved, static_cast<std::size_t>(count)};
  const bool waits = count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
  return {waits ? Socket::Outcome::would_wait : Socket::Outcome::ended, 0};
}

}  // namespace

void Socket::close() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

Socket::Moved Socket::read(std::span<char> into) const {
  return moved(::recv(descriptor_, into.data(), into.size(), 0));
}

Socket::Moved Socket::write(std::span<const std::string_view> pieces) const {
  std::array<iovec, 16> vectors{};
  const std::size_t count = std::min(pieces.size(), vectors.size());
  for (std::size_t i = 0; i < count; ++i) {
    vectors[i] = {const_cast<char*>(pieces[i].data()), pieces[i].size()};  // only ever read
  }
  msghdr message{};
  message.msg_iov = vectors.data();
  message.msg_iovlen = count;
  return moved(::sendmsg(descriptor_, &message, MSG_NOSIGNAL));
}

void Socket::finish_writing() const { ::shutdown(descriptor_, SHUT_WR); }

}  // namespace dini::server

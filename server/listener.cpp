#include "server/listener.h"

#include <fcntl.h>
#include <httplib.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace dini::server {
namespace {

/// cpp-httplib finds the address and binds to it; accepting is not left to it (docs/decisions/0024-http-core.md).
class Binder : private httplib::Server {
 public:
  Binder() {
    // The library's default also sets SO_REUSEPORT: two servers would then share one port without a word.
    set_socket_options([](socket_t descriptor) {
      const int yes = 1;
      ::setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
  }

  int bind(const std::string& host, int port) {
    if (port == 0) return std::max(0, bind_to_any_port(host));
    return bind_to_port(host, port) ? port : 0;
  }

  int take_descriptor() { return svr_sock_.exchange(INVALID_SOCKET); }
};

}  // namespace

int Listener::listen(const std::string& host, int port) {
  // The library listens with a backlog of 5, which turns a burst of connections into seconds of retransmits.
  constexpr int backlog = 4096;
  Binder binder;
  const int bound = binder.bind(host, port);
  if (bound == 0) return 0;
  descriptor_ = binder.take_descriptor();
  ::fcntl(descriptor_, F_SETFL, ::fcntl(descriptor_, F_GETFL) | O_NONBLOCK);
  return ::listen(descriptor_, backlog) == 0 ? bound : 0;
}

int Listener::accept() const {
  const int descriptor = ::accept4(descriptor_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (descriptor < 0) return descriptor;
  // An answer leaves in one write; without this its last part would wait for an acknowledgment of the one before.
  const int yes = 1;
  ::setsockopt(descriptor, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  return descriptor;
}

void Listener::close() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

}  // namespace dini::server

#include "server/guard.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <poll.h>
#include <random>
#include <sys/eventfd.h>
#include <unistd.h>

#include "server/responses.h"
#include "server/text.h"

namespace dini::server {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int accept_backlog = 1024;
constexpr std::size_t read_bytes = 16 * 1024;
constexpr std::size_t write_bytes_per_second = 64 * 1024;
constexpr std::size_t read_bytes_per_second = 1024 * 1024;
constexpr std::size_t small_body = 1024 * 1024;
constexpr std::chrono::milliseconds crowd_check{500};

/// What cpp-httplib gets to read and write: a request line from memory, and the socket with its deadline for the
/// answer.
class AnswerStream final : public httplib::Stream {
 public:
  AnswerStream(const Socket& socket, std::string head, std::chrono::milliseconds write_deadline)
      : socket_(socket), head_(std::move(head)), write_deadline_(write_deadline) {}

  bool is_readable() const override { return true; }
  bool is_writable() const override { return true; }

  ssize_t read(char* into, std::size_t size) override {
    const std::size_t count = head_.copy(into, size, position_);
    position_ += count;
    return static_cast<ssize_t>(count);
  }

  ssize_t write(const char* bytes, std::size_t size) override {
    const auto deadline = Clock::now() + write_deadline_ + std::chrono::seconds(size / write_bytes_per_second);
    if (!socket_.write({bytes, size}, deadline)) return -1;
    written_ += size;
    return static_cast<ssize_t>(size);
  }

  void get_remote_ip_and_port(std::string& ip, int& port) const override {
    ip.clear();
    port = 0;
  }
  void get_local_ip_and_port(std::string& ip, int& port) const override { get_remote_ip_and_port(ip, port); }
  socket_t socket() const override { return socket_.descriptor(); }

  std::size_t written() const { return written_; }

 private:
  const Socket& socket_;
  std::string head_;
  std::size_t position_ = 0;
  std::chrono::milliseconds write_deadline_;
  std::size_t written_ = 0;
};

/// A place among the few for large bodies, given back at the end of its scope; for a small body nothing.
class LargeBody {
 public:
  LargeBody(std::counting_semaphore<>& places, bool wanted)
      : places_(wanted ? &places : nullptr), held_(!wanted || places.try_acquire()) {}
  LargeBody(const LargeBody&) = delete;
  ~LargeBody() {
    if (places_ != nullptr && held_) places_->release();
  }

  bool held() const { return held_; }

 private:
  std::counting_semaphore<>* places_;
  bool held_;
};

/// The exchange of the request that cpp-httplib is handling on this thread: its callbacks carry no context of ours.
thread_local Exchange* current_exchange = nullptr;

std::size_t end_of_head(std::string_view bytes) {
  const auto end = bytes.find("\r\n\r\n");
  return end == std::string_view::npos ? end : end + 4;
}

/// For the log: what can be said about a request that was refused before it was understood.
Access access_of(std::string_view buffer) {
  const std::string_view line = buffer.substr(0, std::min(buffer.find('\r'), buffer.size()));
  const auto space = line.find(' ');
  if (space == std::string_view::npos) return {.method = "-", .path = std::string(line.substr(0, 256))};
  return {.method = std::string(line.substr(0, space)), .path = std::string(line.substr(space + 1, 256))};
}

/// Tells the requests of this run from those of others in the logs.
std::string random_name() {
  std::random_device random;
  return content_hash(std::to_string(random()) + " " + std::to_string(random())).substr(0, 8);
}

}  // namespace

Guard::Guard(const Settings& settings, BodyLimit body_limit, Application application, Log log)
    : settings_(settings),
      body_limit_(std::move(body_limit)),
      application_(std::move(application)),
      log_(std::move(log)),
      run_name_(random_name()),
      large_bodies_(static_cast<std::ptrdiff_t>(settings.large_bodies)),
      stop_event_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      queue_(settings.connection_threads, settings.waiting_connections,
             [this](int descriptor) { process_and_close_socket(descriptor); }) {
  set_tcp_nodelay(
      true);  // head and body leave in two writes; without this each answer waits 40 ms for an acknowledgment
  set_keep_alive_max_count(1'000'000);
  set_keep_alive_timeout(std::chrono::duration_cast<std::chrono::seconds>(settings.idle_deadline).count());
  // The library's default also sets SO_REUSEPORT: two servers would then share one port without a word.
  set_socket_options([](socket_t descriptor) {
    const int yes = 1;
    ::setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  // Everything is answered here, so the library never routes, reads a body or serves a file.
  set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
    Reply reply = application_(request, *current_exchange);
    add_common_headers(reply, *current_exchange);
    response.status = current_exchange->status = reply.status;
    for (const auto& [name, value] : reply.headers) response.set_header(name, value);
    if (!reply.type.empty()) response.set_header("Content-Type", reply.type);
    response.body = std::move(reply.body);
    return HandlerResponse::Handled;
  });
  set_post_routing_handler([this](const httplib::Request&, httplib::Response& response) {
    if (stopping()) {
      response.headers.erase("Keep-Alive");
      response.headers.erase("Connection");
      response.set_header("Connection", "close");
    }
    response.headers.erase("Accept-Ranges");                               // offered for HEAD, never honored
    if (response.status == 304) response.headers.erase("Content-Length");  // it would be that of the full answer
  });
}

Guard::~Guard() {
  stop_accepting();
  cut_connections();
  queue_.finish();
  if (svr_sock_ != INVALID_SOCKET) ::close(svr_sock_);
  ::close(stop_event_);
}

int Guard::bind() {
  int port = settings_.port;
  if (port == 0) {
    port = std::max(0, bind_to_any_port(settings_.host));
  } else if (!bind_to_port(settings_.host, port)) {
    port = 0;
  }
  // The library listens with a backlog of 5, which turns a burst of connections into seconds of retransmits.
  if (port != 0) ::listen(svr_sock_, accept_backlog);
  return port;
}

// The library's own loop ends for good at the first accept error it does not know, and has no bounded queue.
void Guard::run() {
  std::array<pollfd, 2> waits = {pollfd{svr_sock_, POLLIN, 0}, pollfd{stop_event_, POLLIN, 0}};
  while (!stopping()) {
    if (::poll(waits.data(), waits.size(), -1) < 0 || waits[0].revents == 0) continue;
    const int descriptor = ::accept4(svr_sock_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (descriptor < 0) {
      // Out of descriptors or memory: the connection stays in the backlog until some are free again.
      const bool exhausted = errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM;
      if (exhausted) std::this_thread::sleep_for(std::chrono::milliseconds(10));
      continue;
    }
    {
      const std::lock_guard lock(open_mutex_);
      open_.insert(descriptor);
    }
    if (!queue_.push(descriptor)) turn_away(descriptor);
  }
  ::close(svr_sock_.exchange(INVALID_SOCKET));
}

void Guard::stop_accepting() {
  stopping_ = true;
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(stop_event_, &one, sizeof one);
}

bool Guard::wait_closed(Clock::time_point deadline) {
  std::unique_lock lock(open_mutex_);
  return closed_.wait_until(lock, deadline, [this] { return open_.empty(); });
}

void Guard::cut_connections() {
  const std::lock_guard lock(open_mutex_);
  for (const int descriptor : open_) ::shutdown(descriptor, SHUT_RDWR);
}

bool Guard::process_and_close_socket(socket_t descriptor) {
  const Socket socket(descriptor);
  std::string buffer;
  bool fresh = true;
  while (wait_for_request(socket, fresh) && answer_one(socket, buffer)) fresh = false;
  forget(descriptor);
  return true;
}

/// Before the socket is closed and its number given to another connection.
void Guard::forget(int descriptor) {
  const std::lock_guard lock(open_mutex_);
  open_.erase(descriptor);
  closed_.notify_all();
}

bool Guard::wait_for_request(const Socket& socket, bool fresh) const {
  const auto started = Clock::now();
  const auto deadline = started + (fresh ? settings_.head_deadline : settings_.idle_deadline);
  while (true) {
    const auto slice = std::min(deadline, Clock::now() + crowd_check);
    switch (socket.wait_readable(slice, stop_event_)) {
      case Socket::Wait::ready:
        return true;
      case Socket::Wait::interrupted:
        return false;
      case Socket::Wait::late:
        if (slice == deadline || (queue_.crowded() && !fresh)) return false;
    }
  }
}

bool Guard::answer_one(const Socket& socket, std::string& buffer) {
  Exchange exchange;
  exchange.socket = socket.descriptor();
  const auto refuse_and_close = [&](const Problem& problem) {
    refuse(socket, problem, access_of(buffer), exchange);
    return false;
  };

  auto head = read_head(socket, buffer);
  if (!head && head.problems().front().code == "closed") return false;
  exchange.id = run_name_ + "-" + std::to_string(++request_count_);
  if (!head) return refuse_and_close(head.problems().front());
  const std::size_t head_size = end_of_head(buffer);
  // Each connection may hold a small body in memory; of the large ones there is room for a few.
  const LargeBody place(large_bodies_, head->content_length > small_body);
  if (!place.held()) {
    return refuse_and_close({.code = "busy", .detail = "Too many large files arrive at once; try again in a moment."});
  }
  if (head->expects_continue && buffer.size() == head_size) {
    if (!socket.write("HTTP/1.1 100 Continue\r\n\r\n", Clock::now() + settings_.write_deadline)) return false;
  }
  const std::size_t size = head_size + head->content_length;
  if (!read_body(socket, buffer, size)) {
    return refuse_and_close({.code = "request-timeout", .detail = "The body did not arrive in time."});
  }
  // Bytes past the request would be a pipelined one, or one smuggled through a proxy that counts differently: no
  // telling.
  const bool leftover = buffer.size() > size;
  buffer.resize(size);
  buffer.erase(0, head_size);
  const bool last = head->close || leftover || stopping();
  const bool written = answer(socket, *head, std::move(buffer), exchange, last);
  buffer.clear();
  if (leftover && written) socket.linger();
  return written && !last && !stopping();
}

Result<RequestHead> Guard::read_head(const Socket& socket, std::string& buffer) const {
  const auto deadline = Clock::now() + settings_.head_deadline;
  std::array<char, read_bytes> bytes{};
  while (end_of_head(buffer) == std::string::npos) {
    const std::size_t room = std::min(bytes.size(), settings_.head_bytes - buffer.size());
    const std::size_t count = socket.read(bytes.data(), room, deadline);
    if (count == 0) {
      if (buffer.empty() || Clock::now() < deadline) return Problem{.code = "closed", .detail = "The client left."};
      return Problem{.code = "request-timeout", .detail = "The headers did not arrive in time."};
    }
    buffer.append(bytes.data(), count);
    if (end_of_head(buffer) != std::string::npos) break;
    if (auto problem = check_unfinished_head(buffer, settings_)) return *std::move(problem);
  }
  return parse_head(std::string_view(buffer).substr(0, end_of_head(buffer)), settings_, body_limit_);
}

bool Guard::read_body(const Socket& socket, std::string& buffer, std::size_t size) const {
  const auto deadline = Clock::now() + settings_.body_deadline + std::chrono::seconds(size / read_bytes_per_second);
  std::array<char, read_bytes> bytes{};
  while (buffer.size() < size) {
    const std::size_t count = socket.read(bytes.data(), std::min(bytes.size(), size - buffer.size() + 1), deadline);
    if (count == 0) return false;
    buffer.append(bytes.data(), count);
  }
  return true;
}

bool Guard::answer(const Socket& socket, const RequestHead& head, std::string body, Exchange& exchange, bool last) {
  AnswerStream stream(socket, head.request_line(), settings_.write_deadline);
  Access access{.method = head.method, .path = head.target};
  const auto set_up = [&](httplib::Request& request) {
    request.body = std::move(body);
    request.headers = {head.headers.begin(), head.headers.end()};
    const std::string encodings = to_lower(request.get_header_value("Accept-Encoding"));
    exchange.accepts_gzip =
        encodings.find("gzip") != std::string::npos && encodings.find("gzip;q=0") == std::string::npos;
    // Without this header the library compresses nothing. It would use brotli at its slowest: seconds for a megabyte.
    request.headers.erase("Accept-Encoding");
  };
  current_exchange = &exchange;
  bool closed = last;
  const bool written = process_request(stream, last, closed, set_up);
  current_exchange = nullptr;
  access.status = exchange.status;
  access.bytes = stream.written();
  log_(access, exchange);
  return written && !closed;
}

void Guard::refuse(const Socket& socket, const Problem& problem, Access access, const Exchange& exchange) const {
  Reply reply = problem_reply(problem, exchange);
  if (problem.code == "method-not-allowed") reply.headers.emplace_back("Allow", "GET, HEAD, POST");
  add_common_headers(reply, exchange);
  const std::string bytes = closing_answer(reply);
  access.status = reply.status;
  access.bytes = bytes.size();
  if (socket.write(bytes, Clock::now() + settings_.write_deadline)) socket.linger();
  log_(access, exchange);
}

/// On the accepting thread, so nothing here may wait: what fits into the socket's buffer is sent, and that is plenty.
void Guard::turn_away(int descriptor) {
  const Socket socket(descriptor);
  Exchange exchange;
  exchange.id = run_name_ + "-" + std::to_string(++request_count_);
  Reply reply =
      problem_reply(Problem{.code = "busy", .detail = "Every connection is taken; try again in a moment."}, exchange);
  add_common_headers(reply, exchange);
  const std::string bytes = closing_answer(reply);
  std::array<char, read_bytes> unread{};
  ::recv(descriptor, unread.data(), unread.size(), MSG_DONTWAIT);
  ::send(descriptor, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  ::shutdown(descriptor, SHUT_WR);
  forget(descriptor);
  log_({.method = "-", .path = "-", .status = reply.status, .bytes = bytes.size()}, exchange);
}

}  // namespace dini::server

#include "server/connections.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <poll.h>
#include <random>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <unistd.h>

#include "server/text.h"

namespace dini::server {
namespace {

constexpr std::size_t buffer_bytes = 64 * 1024;
constexpr std::size_t large_body = 64 * 1024;
constexpr std::chrono::milliseconds sweep_pause{50};
constexpr std::chrono::milliseconds accept_pause{20};
/// Descriptors that everything else may need: standard streams, the loop's own, files.
constexpr std::size_t other_descriptors = 32;

/// Tells the requests of this run from those of others in the logs.
std::string random_name() {
  std::random_device random;
  return content_hash(std::to_string(random()) + " " + std::to_string(random())).substr(0, 8);
}

std::size_t connection_limit(const Settings& settings) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return settings.connections;
  const auto descriptors = static_cast<std::size_t>(limit.rlim_cur);
  const std::size_t spare = descriptors > 2 * other_descriptors ? descriptors - other_descriptors : descriptors / 2;
  return std::max<std::size_t>(1, std::min(settings.connections, spare));
}

/// Whether a client has connected that has yet to be accepted.
bool someone_waits_at(int listener) {
  pollfd ready{listener, POLLIN, 0};
  return ::poll(&ready, 1, 0) > 0;
}

int milliseconds_until(Connection::Clock::time_point time) {
  if (time == Connection::Clock::time_point::max()) return -1;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(time - Connection::Clock::now()).count();
  return static_cast<int>(std::clamp<decltype(left)>(left, 0, 60'000));
}

}  // namespace

Connections::Connections(const Settings& settings, AnswerThreads& threads, Admission admission, Answering answering,
                         Log log)
    : settings_(settings),
      threads_(threads),
      admission_(std::move(admission)),
      answering_(std::move(answering)),
      log_(std::move(log)),
      run_name_(random_name()),
      most_connections_(connection_limit(settings)),
      poller_(::epoll_create1(EPOLL_CLOEXEC)),
      bell_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      buffer_(buffer_bytes) {}

Connections::~Connections() {
  cut();
  if (poller_ >= 0) ::close(poller_);
  if (bell_ >= 0) ::close(bell_);
}

int Connections::listen() {
  if (poller_ < 0 || bell_ < 0) return 0;
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = bell_;
  if (::epoll_ctl(poller_, EPOLL_CTL_ADD, bell_, &event) != 0) return 0;
  return listener_.listen(settings_.host, settings_.port);
}

void Connections::start() {
  running_ = true;
  thread_ = std::thread([this] { run(); });
}

void Connections::drain() {
  draining_ = true;
  ring();
}

void Connections::cut() {
  cutting_ = true;
  drain();
  if (thread_.joinable()) thread_.join();
}

bool Connections::wait_closed(Clock::time_point deadline) {
  std::unique_lock lock(mutex_);
  return closed_.wait_until(lock, deadline, [this] { return open_ == 0 && !running_; });
}

std::size_t Connections::open() const {
  const std::lock_guard lock(mutex_);
  return open_;
}

void Connections::ring() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(bell_, &one, sizeof one);
}

void Connections::wake(const std::shared_ptr<Connection>& connection) {
  bool first = false;
  {
    const std::lock_guard lock(mutex_);
    if (connection->is_woken) return;
    connection->is_woken = true;
    first = woken_ == nullptr;
    connection->next_woken = std::move(woken_);
    woken_ = connection;
  }
  if (first) ring();
}

void Connections::answer(const std::shared_ptr<Call>& call) {
  const bool large = call->request.body.size() > large_body;
  threads_.post([this, call] { answering_(call); }, large ? AnswerThreads::Size::large : AnswerThreads::Size::small);
}

std::string Connections::next_id() { return run_name_ + "-" + std::to_string(++request_count_); }

bool Connections::take_incoming(std::size_t bytes) {
  if (incoming_bytes_ + bytes > settings_.incoming_bytes) return false;
  incoming_bytes_ += bytes;
  return true;
}

bool Connections::take_unsent(std::size_t bytes) {
  if (unsent_bytes_ + bytes > settings_.unsent_bytes) return false;
  unsent_bytes_ += bytes;
  return true;
}

/// Out of memory in the middle of a step: the connection is given up rather than left in between. It says so if it can.
template <class Step>
void Connections::guarded(const std::shared_ptr<Connection>& connection, Step step) {
  try {
    step(*connection);
  } catch (...) {
    connection->give_up();
  }
  finish(connection);
}

void Connections::finish(const std::shared_ptr<Connection>& connection) {
  if (connection->state() != Connection::State::closed) {
    next_sweep_ = std::min(next_sweep_, connection->deadline());
    return;
  }
  const auto place = connections_.find(connection->descriptor());
  if (place == connections_.end() || place->second != connection) return;  // it has been seen to before
  ::epoll_ctl(poller_, EPOLL_CTL_DEL, connection->descriptor(), nullptr);
  connection->hang_up();
  connections_.erase(place);
  const std::lock_guard lock(mutex_);
  open_ = connections_.size();
}

void Connections::log(const Access& access, const Exchange& exchange) noexcept {
  try {
    log_(access, exchange);
  } catch (...) {
    // Without memory there is no log, but there are answers.
  }
}

void Connections::run() {
  while (!cutting_ && !(drained_ && connections_.empty())) {
    try {
      turn();
    } catch (...) {
      // Memory ran out outside of any one connection; whatever it was is done at the next turn.
    }
  }
  while (!connections_.empty()) {
    guarded(std::shared_ptr(connections_.begin()->second), [](Connection& connection) { connection.close(); });
  }
  const std::lock_guard lock(mutex_);
  running_ = false;
  open_ = 0;
  closed_.notify_all();
}

/// Waits for something to happen and sees to it.
void Connections::turn() {
  std::array<epoll_event, 256> events{};
  if (!accepting_ && !drained_ && Clock::now() >= accept_again_) begin_accepting();
  const int count = ::epoll_wait(poller_, events.data(), static_cast<int>(events.size()),
                                 milliseconds_until(std::min(next_sweep_, accept_again_)));
  for (int i = 0; i < std::max(0, count); ++i) {
    const epoll_event& event = events[static_cast<std::size_t>(i)];
    if (event.data.fd == listener_.descriptor()) {
      accept_all();
    } else if (event.data.fd == bell_) {
      std::uint64_t rings = 0;
      [[maybe_unused]] const ssize_t heard = ::read(bell_, &rings, sizeof rings);
    } else if (const auto found = connections_.find(event.data.fd); found != connections_.end()) {
      const Connection::Ready ready{(event.events & EPOLLIN) != 0, (event.events & EPOLLOUT) != 0,
                                    (event.events & EPOLLRDHUP) != 0, (event.events & (EPOLLERR | EPOLLHUP)) != 0};
      guarded(std::shared_ptr(found->second), [&](Connection& connection) { connection.on_ready(ready, buffer_); });
    }
  }
  serve_woken();
  if (draining_ && !drained_) {
    drained_ = true;
    stop_listening();
  }
  if (Clock::now() >= next_sweep_) sweep();
}

void Connections::serve_woken() {
  std::shared_ptr<Connection> woken;
  {
    const std::lock_guard lock(mutex_);
    woken = std::move(woken_);
  }
  while (woken != nullptr) {
    std::shared_ptr<Connection> next;
    {
      const std::lock_guard lock(mutex_);
      next = std::move(woken->next_woken);
      woken->is_woken = false;
    }
    guarded(woken, [this](Connection& connection) { connection.on_woken(buffer_); });
    woken = std::move(next);
  }
}

void Connections::begin_accepting() {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = listener_.descriptor();
  accepting_ = ::epoll_ctl(poller_, EPOLL_CTL_ADD, listener_.descriptor(), &event) == 0;
  accept_again_ = accepting_ ? Clock::time_point::max() : Clock::now() + accept_pause;
}

/// Out of room or of descriptors: who comes now waits in the backlog until there may be some again.
void Connections::pause_accepting() {
  ::epoll_ctl(poller_, EPOLL_CTL_DEL, listener_.descriptor(), nullptr);
  accepting_ = false;
  accept_again_ = Clock::now() + accept_pause;
}

void Connections::accept_all() {
  constexpr int most_at_once = 64;
  for (int i = 0; i < most_at_once; ++i) {
    if (connections_.size() >= most_connections_) {
      // Nobody is closed for one who does not come.
      if (!someone_waits_at(listener_.descriptor())) return;
      if (!make_room()) return pause_accepting();
    }
    const int descriptor = listener_.accept();
    if (descriptor >= 0) {
      accept_one(descriptor);
    } else if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) {
      return pause_accepting();
    } else if (errno != EINTR && errno != ECONNABORTED) {
      return;
    }
  }
}

void Connections::accept_one(int descriptor) {
  try {
    auto connection = std::make_shared<Connection>(static_cast<Home&>(*this), descriptor);
    connections_.emplace(descriptor, connection);
    epoll_event event{};
    event.events = EPOLLIN | EPOLLOUT | EPOLLRDHUP | EPOLLET;
    event.data.fd = descriptor;
    if (::epoll_ctl(poller_, EPOLL_CTL_ADD, descriptor, &event) != 0) connection->close();
    finish(connection);
    const std::lock_guard lock(mutex_);
    open_ = connections_.size();
  } catch (...) {
    if (connections_.erase(descriptor) == 0) ::close(descriptor);
  }
}

/// Closes the connection that has been waiting for a request longest.
bool Connections::make_room() {
  std::shared_ptr<Connection> oldest;
  for (const auto& [descriptor, connection] : connections_) {
    if (!connection->is_idle() || (oldest != nullptr && connection->since() >= oldest->since())) continue;
    oldest = connection;
  }
  if (oldest == nullptr) return false;
  guarded(oldest, [](Connection& connection) { connection.close(); });
  return true;
}

/// Accepts who has connected already, since closing the socket would reset them, then closes it.
void Connections::stop_listening() {
  while (someone_waits_at(listener_.descriptor()) && (connections_.size() < most_connections_ || make_room())) {
    const int descriptor = listener_.accept();
    if (descriptor >= 0) {
      accept_one(descriptor);
    } else if (errno != EINTR && errno != ECONNABORTED) {
      break;
    }
  }
  accept_again_ = Clock::time_point::max();
  listener_.close();
  for (const auto& [descriptor, connection] : connections_) {
    connection->drain();
    next_sweep_ = std::min(next_sweep_, connection->deadline());
  }
}

void Connections::sweep() {
  const Clock::time_point now = Clock::now();
  next_sweep_ = Clock::time_point::max();
  for (auto place = connections_.begin(); place != connections_.end();) {
    const std::shared_ptr<Connection> connection = (place++)->second;  // it may be gone from here afterwards
    guarded(connection, [&](Connection& one) { one.on_time(now); });
  }
  // So that many deadlines one after the other do not mean many sweeps.
  if (next_sweep_ != Clock::time_point::max()) next_sweep_ = std::max(next_sweep_, now + sweep_pause);
}

}  // namespace dini::server

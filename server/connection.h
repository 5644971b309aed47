#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "server/call.h"
#include "server/incoming_body.h"
#include "server/request_head.h"
#include "server/request_log.h"
#include "server/sending.h"
#include "server/socket.h"

namespace dini::server {

class Connection;

/// What a connection needs of the loop that it lives in.
class Home {
 public:
  virtual ~Home() = default;

  virtual const Settings& settings() const = 0;
  /// Looks at a head: how long its body may be, or the answer if the request is refused before its body is read.
  virtual std::variant<std::size_t, Reply> admit(const RequestHead& head, const Exchange& exchange) = 0;
  /// Lets a complete request be answered.
  virtual void answer(const std::shared_ptr<Call>& call) = 0;
  /// Calls `on_woken` soon, on the thread of the loop. From any thread; needs no memory.
  virtual void wake(const std::shared_ptr<Connection>& connection) = 0;
  virtual std::string next_id() = 0;
  virtual bool is_draining() const = 0;
  virtual void log(const Access& access, const Exchange& exchange) noexcept = 0;
  /// Bytes of bodies that arrive and of answers that wait, over all connections; false when there are too many.
  virtual bool take_incoming(std::size_t bytes) = 0;
  virtual void give_incoming(std::size_t bytes) = 0;
  virtual bool take_unsent(std::size_t bytes) = 0;
  virtual void give_unsent(std::size_t bytes) = 0;
};

/// One connection: reads a request, has it answered, writes the answer, and so on. It costs no thread while it waits
/// for its peer. Everything but `deliver` and `watch` is called by the one thread of the loop.
class Connection final : public Asker, public std::enable_shared_from_this<Connection> {
 public:
  using Clock = std::chrono::steady_clock;
  enum class State { reading, answering, writing, lingering, closed };

  Connection(Home& home, int descriptor);
  ~Connection() override;

  void deliver(std::unique_ptr<Reply> reply) override;
  void watch(std::shared_ptr<jobs::Flights::Interest> interest) override;

  /// What the descriptor is said to be ready for; edges, each told once.
  struct Ready {
    bool read = false;
    bool write = false;
    bool half_closed = false;  ///< the peer will send no more
    bool broken = false;
  };
  void on_ready(const Ready& ready, std::span<char> buffer);

  /// Writes the answer that was delivered, if one was, and goes on reading.
  void on_woken(std::span<char> buffer);

  /// Ends what has taken too long.
  void on_time(Clock::time_point now);

  /// The server is stopping: idle ones get a moment for a request that is on its way, and no further one.
  void drain();

  State state() const { return state_; }
  /// The number of its descriptor, also after it has been hung up.
  int descriptor() const { return descriptor_; }
  /// Between two requests, or before the first.
  bool is_idle() const { return state_ == State::reading && input_.empty() && !head_; }
  Clock::time_point since() const { return since_; }
  Clock::time_point deadline() const { return deadline_; }

  /// Says that there is no memory, if that can still be said; else ends it.
  void give_up() noexcept;

  /// Ends it: whoever computes for it is told. Its descriptor stays open until `hang_up`.
  void close() noexcept;
  void hang_up() { socket_.close(); }

  std::shared_ptr<Connection> next_woken;  ///< in the loop's list of those to be woken; belongs to the loop's lock
  bool is_woken = false;                   ///< is in it

 private:
  void read(std::span<char> buffer);
  void take(std::string_view bytes);
  void take_head();
  void take_body(std::string_view bytes);
  void set_body_deadline();
  void finish_request();
  void refuse(const Problem& problem);
  void refuse(Reply reply);
  void begin_answer(std::unique_ptr<Reply> reply);
  void write();
  void begin_wait_for_peer();
  void finish_answer();
  void linger();
  void expect_request();
  void notice_half_close();
  void write_log() noexcept;

  Home& home_;
  const int descriptor_;
  Socket socket_;
  State state_ = State::reading;
  Clock::time_point since_;     ///< when the current wait began
  Clock::time_point deadline_;  ///< of the current wait
  bool readable_ = true;        ///< there may be more to read
  bool half_closed_ = false;
  bool probed_ = false;  ///< the beginning of the answer has been sent ahead

  std::string input_;  ///< of the head; then whatever came behind the request
  std::optional<RequestHead> head_;
  std::optional<IncomingBody> body_;
  Clock::time_point body_begun_;
  std::size_t held_incoming_ = 0;
  std::optional<Exchange> exchange_;
  Access access_;
  bool last_ = false;  ///< no further request is taken

  Sending sending_;
  std::size_t sent_before_wait_ = 0;  ///< of the current piece, at the beginning of the current time to write in
  std::size_t held_unsent_ = 0;

  std::mutex mutex_;  ///< of what other threads touch
  std::unique_ptr<Reply> delivered_;
  bool has_delivered_ = false;
  bool client_gone_ = false;
  std::shared_ptr<jobs::Flights::Interest> interest_;
};

}  // namespace dini::server

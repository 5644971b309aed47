#pragma once

// The event loop: one thread that accepts connections, reads requests and writes answers, so that a peer who waits or
// is slow costs a little memory and no thread.

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "server/answer_threads.h"
#include "server/connection.h"
#include "server/listener.h"

namespace dini::server {

class Connections final : private Home {
 public:
  using Clock = Connection::Clock;
  /// How long a body may follow a head, or the answer if the request is refused before it. Must be quick.
  using Admission = std::function<std::variant<std::size_t, Reply>(const RequestHead&, const Exchange&)>;
  /// Sees to it that a call is answered, on one of the threads for answers.
  using Answering = std::function<void(const std::shared_ptr<Call>&)>;
  using Log = std::function<void(const Access&, const Exchange&)>;

  Connections(const Settings& settings, AnswerThreads& threads, Admission admission, Answering answering, Log log);
  /// Nothing that was given a call may answer it any more.
  ~Connections() override;

  /// The port listened on, or 0 when the address cannot be had.
  int listen();

  /// Begins to accept connections.
  void start();

  /// Accepts what has been connected so far and nothing more; makes every answer the last one of its connection. Any
  /// thread.
  void drain();

  /// True when every connection has been closed before the deadline.
  bool wait_closed(Clock::time_point deadline);

  /// Closes what is still open.
  void cut();

  std::size_t open() const;
  bool is_draining() const override { return draining_.load(std::memory_order_relaxed); }

 private:
  const Settings& settings() const override { return settings_; }
  std::variant<std::size_t, Reply> admit(const RequestHead& head, const Exchange& exchange) override {
    return admission_(head, exchange);
  }
  void answer(const std::shared_ptr<Call>& call) override;
  void wake(const std::shared_ptr<Connection>& connection) override;
  std::string next_id() override;
  void log(const Access& access, const Exchange& exchange) noexcept override;
  bool take_incoming(std::size_t bytes) override;
  void give_incoming(std::size_t bytes) override { incoming_bytes_ -= bytes; }
  bool take_unsent(std::size_t bytes) override;
  void give_unsent(std::size_t bytes) override { unsent_bytes_ -= bytes; }

  void run();
  void turn();
  void begin_accepting();
  void pause_accepting();
  void accept_all();
  void accept_one(int descriptor);
  bool make_room();
  void serve_woken();
  void stop_listening();
  void sweep();
  void finish(const std::shared_ptr<Connection>& connection);
  template <class Step>
  void guarded(const std::shared_ptr<Connection>& connection, Step step);
  void ring();

  const Settings& settings_;
  AnswerThreads& threads_;
  const Admission admission_;
  const Answering answering_;
  const Log log_;
  const std::string run_name_;
  std::uint64_t request_count_ = 0;
  std::size_t incoming_bytes_ = 0;
  std::size_t unsent_bytes_ = 0;
  std::size_t most_connections_ = 0;

  Listener listener_;
  int poller_ = -1;
  int bell_ = -1;  ///< wakes the loop
  bool accepting_ = false;
  bool drained_ = false;                                       ///< nothing is accepted any more
  Clock::time_point accept_again_ = Clock::time_point::min();  ///< while not accepting
  Clock::time_point next_sweep_ = Clock::time_point::max();
  std::vector<char> buffer_;
  std::map<int, std::shared_ptr<Connection>> connections_;  ///< by descriptor

  std::atomic<bool> draining_ = false;
  std::atomic<bool> cutting_ = false;
  mutable std::mutex mutex_;
  std::shared_ptr<Connection> woken_;  ///< the last one to be woken, and those before it
  std::condition_variable closed_;
  std::size_t open_ = 0;
  bool running_ = false;
  std::thread thread_;
};

}  // namespace dini::server

#pragma once

// cpp-httplib behind a fence. Debian's 0.11.4 reads chunked bodies past every limit, buffers lines and headers without
// bound, inflates bombs and leaves unread bodies on the wire as the next request. So the guard reads requests itself,
// strictly, within budgets and absolute deadlines, and hands cpp-httplib only finished ones; cpp-httplib parses them
// again into its Request and writes the answers.

#include <functional>
#include <httplib.h>
#include <memory>
#include <mutex>
#include <semaphore>
#include <set>

#include "server/connection_queue.h"
#include "server/reply.h"
#include "server/request_head.h"
#include "server/settings.h"
#include "server/socket.h"

namespace dini::server {

/// One line of the access log.
struct Access {
  std::string method;
  std::string path;
  int status = 0;
  std::size_t bytes = 0;
};

class Guard : private httplib::Server {
 public:
  /// Answers a request whose head is well-formed and whose body is complete. Must not throw.
  using Application = std::function<Reply(const httplib::Request&, Exchange&)>;
  using Log = std::function<void(const Access&, const Exchange&)>;

  Guard(const Settings& settings, BodyLimit body_limit, Application application, Log log);
  ~Guard() override;

  /// The port listened on, or 0 when the address cannot be had.
  int bind();

  /// Accepts connections until `stop_accepting` is called.
  void run();

  /// Ends `run`, closes idle connections, and makes every further answer the last of its connection. Any thread.
  void stop_accepting();

  /// True when every connection has been closed before the deadline.
  bool wait_closed(std::chrono::steady_clock::time_point deadline);

  /// Cuts the connections that are still open.
  void cut_connections();

 private:
  bool process_and_close_socket(socket_t descriptor) override;
  bool answer_one(const Socket& socket, std::string& buffer);
  bool wait_for_request(const Socket& socket, bool fresh) const;
  Result<RequestHead> read_head(const Socket& socket, std::string& buffer) const;
  bool read_body(const Socket& socket, std::string& buffer, std::size_t size) const;
  bool answer(const Socket& socket, const RequestHead& head, std::string body, Exchange& exchange, bool last);
  void refuse(const Socket& socket, const Problem& problem, Access access, const Exchange& exchange) const;
  void turn_away(int descriptor);
  void forget(int descriptor);
  bool stopping() const { return stopping_.load(std::memory_order_relaxed); }

  const Settings settings_;
  const BodyLimit body_limit_;
  const Application application_;
  const Log log_;
  const std::string run_name_;
  std::atomic<std::uint64_t> request_count_ = 0;
  std::counting_semaphore<> large_bodies_;  ///< free places
  std::atomic<bool> stopping_ = false;
  int stop_event_ = -1;  ///< readable for good once stopping

  std::mutex open_mutex_;
  std::condition_variable closed_;
  std::set<int> open_;
  ConnectionQueue queue_;
};

}  // namespace dini::server

#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "queue/connection.h"

namespace dini::queue {

/// Whether Redis is well, as a thread of its own finds out again and again, so that nobody who waits for an answer has
/// to: what is known to be away costs nothing.
class Link {
 public:
  /// Looks once before it returns.
  explicit Link(const Address& address);
  ~Link();
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  bool is_well() const { return well_.load(); }
  /// What is wrong at this moment; empty when nothing is.
  std::string trouble() const;
  /// Somebody has seen that it is not well; the thread finds out when it is again.
  void note(const Fault& fault);
  const Address& address() const { return address_; }

 private:
  void look();
  void watch();

  const Address address_;
  Connection connection_;
  std::atomic<bool> well_ = false;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::string trouble_;
  bool stopped_ = false;
  std::thread thread_;
};

}  // namespace dini::queue

#pragma once

#include <chrono>
#include <cstddef>
#include <list>
#include <map>
#include <mutex>
#include <optional>

#include "server/network.h"

namespace dini::server {

/// How many wrong tokens came from where, so that guessing is slow and seen. Each address may send some at once, and
/// as many again in every minute; past that it is told to wait. Only wrong tokens are counted and refused: the right
/// one is never looked at here, so that nobody is locked out by those with whom they share an address. Any thread.
class WrongTokens {
 public:
  using Clock = std::chrono::steady_clock;

  /// With `most` of 1 or more in a minute.
  explicit WrongTokens(std::size_t most) : most_(static_cast<double>(most)) {}

  /// Counts a wrong token. How long its sender must wait before it may be wrong again; nothing when it need not.
  std::optional<std::chrono::milliseconds> count(const std::optional<Address>& sender, Clock::time_point now);

  /// All wrong tokens so far.
  std::size_t total() const;

  /// Addresses that are remembered: those that were wrong last, at most `most_senders`.
  std::size_t senders() const;

  static constexpr std::size_t most_senders = 4096;

 private:
  struct Sender {
    Address subscriber;
    double left;  ///< of what it may send now
    Clock::time_point seen;
  };

  Sender& sender_of(const Address& subscriber, Clock::time_point now);

  const double most_;
  mutable std::mutex mutex_;
  std::list<Sender> senders_;  ///< who was wrong last stands first
  std::map<Address, std::list<Sender>::iterator> places_;
  std::size_t total_ = 0;
};

}  // namespace dini::server

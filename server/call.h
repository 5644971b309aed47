#pragma once

#include <functional>
#include <memory>
#include <mutex>

#include "graph/digest.h"
#include "jobs/flights.h"
#include "server/packing.h"
#include "server/reply.h"
#include "server/request.h"

namespace dini::server {

/// Where the answer to one request goes: the connection that it came on.
class Asker {
 public:
  virtual ~Asker() = default;

  /// Takes the answer; null when there was no memory to make one. Any thread, once.
  virtual void deliver(std::unique_ptr<Reply> reply) = 0;

  /// From now on, the client leaving stops this interest; at once if it has left already.
  virtual void watch(std::shared_ptr<jobs::Flights::Interest> interest) = 0;
};

/// One request on its way to its answer. Whoever holds it may answer from any thread and at any time. If the last one
/// to hold it lets it go without an answer, because memory ran out or by a bug, the client is told that.
class Call : public std::enable_shared_from_this<Call> {
 public:
  Call(std::shared_ptr<Asker> asker, Request incoming, Exchange known)
      : request(std::move(incoming)), exchange(std::move(known)), asker_(std::move(asker)) {}
  ~Call() {
    if (asker_ != nullptr) asker_->deliver(nullptr);
  }
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  const Request request;
  const Exchange exchange;

  /// Adds to the times that the answer tells: name and milliseconds. By whoever is about to answer.
  void note_time(std::string name, double milliseconds) { notes_.timings.emplace_back(std::move(name), milliseconds); }

  /// Tells the log which graph the request is about, and whether the result was known. By whoever is about to answer.
  void note_graph(const Digest& hash) { notes_.graph = to_hex(hash); }
  void note_cache(std::string_view known) { notes_.cache = known; }

  /// Sends the answer; only the first one counts.
  void reply(Reply reply) {
    reply.notes = std::move(notes_);
    auto answer = std::make_unique<Reply>(packed(std::move(reply), exchange));
    if (const auto asker = take_asker()) asker->deliver(std::move(answer));
  }

  /// What is asked of a computation may be answered, by another thread, before this is called.
  void watch(std::shared_ptr<jobs::Flights::Interest> interest) {
    if (const auto asker = known_asker()) asker->watch(std::move(interest));
  }

 private:
  std::shared_ptr<Asker> known_asker() {
    const std::lock_guard lock(mutex_);
    return asker_;
  }
  std::shared_ptr<Asker> take_asker() {
    const std::lock_guard lock(mutex_);
    return std::exchange(asker_, nullptr);
  }

  std::mutex mutex_;
  std::shared_ptr<Asker> asker_;  ///< null once it has been answered
  AnswerNotes notes_;
};

}  // namespace dini::server

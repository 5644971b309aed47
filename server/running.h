#pragma once

#include <list>
#include <mutex>
#include <thread>

#include "geometry/cancel.h"

namespace dini::server {

/// The requests being computed, and the two outside events that stop them: their client leaves, or the server shuts
/// down. One thread watches all their sockets, so that a disconnect stops the kernels within milliseconds.
class RunningRequests {
 public:
  RunningRequests();
  ~RunningRequests();
  RunningRequests(const RunningRequests&) = delete;
  RunningRequests& operator=(const RunningRequests&) = delete;

  /// One request, from here to the end of its scope. `cancel` must outlive it.
  class Entry {
   public:
    Entry(RunningRequests& requests, int socket, const Cancel& cancel);
    ~Entry();
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;

   private:
    friend class RunningRequests;
    RunningRequests& requests_;
    int socket_;
    const Cancel& cancel_;
    std::list<Entry*>::iterator position_;
  };

  /// Stops every request that runs now.
  void stop_all(StopReason reason);

  std::size_t count() const;

 private:
  void watch();
  void wake() const;

  mutable std::mutex mutex_;
  std::list<Entry*> entries_;
  bool finished_ = false;
  int changed_event_;
  std::thread watcher_;
};

}  // namespace dini::server

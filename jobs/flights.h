#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "graph/digest.h"
#include "graph/job.h"
#include "graph/problem.h"
#include "jobs/alarms.h"
#include "jobs/compute_queue.h"

namespace dini::jobs {

/// Work that several may be waiting for: whoever asks for what is being computed already joins it and takes no place.
///
/// Everybody who asks has an interest in the outcome, and whatever makes that interest end (a deadline, a newer
/// request, a client that leaves, a shutdown) ends this one only. The work itself is stopped when nobody is interested
/// in it any more. So nobody's answer depends on somebody else's patience.
class Flights {
 public:
  using Outcome = Result<std::shared_ptr<const void>>;
  using Clock = Alarms::Clock;
  /// When the work began; nothing when it had not yet.
  using Begun = std::optional<Clock::time_point>;

  Flights(ComputeQueue& queue, Alarms& alarms);
  /// Stops everything, and returns when nothing runs any more.
  ~Flights();
  Flights(const Flights&) = delete;
  Flights& operator=(const Flights&) = delete;

  class Flight;

  /// What somebody has in an outcome, until it is told or stopped.
  class Interest : public std::enable_shared_from_this<Interest> {
   public:
    /// Ends it: unless it has been told, it is told now why not. Any thread, any time, more than once.
    void stop(StopReason reason);

    /// Whether the work runs, for this interest.
    bool has_begun() const;

    /// How far the work is; nothing once the outcome was told or the interest has ended.
    Progress::State progress() const;

   private:
    friend class Flights;
    Flights* flights_ = nullptr;
    std::shared_ptr<Flight> flight_;
    std::function<void(const Outcome&, Begun)> tell_;
    bool told_ = false;
    std::list<std::shared_ptr<Interest>>::iterator place_;
    Alarms::Alarm deadline_;
  };

  struct Terms {
    Digest key{};                                   ///< equal keys mean equal outcomes
    std::size_t bytes = 0;                          ///< memory that the work will hold
    std::size_t work = ComputeQueue::unknown_work;  ///< nanoseconds that it is predicted to take
    Clock::time_point deadline = Clock::time_point::max();
  };

  /// Joins the work of that key or lets it begin. `tell` is called once: with the outcome, on the thread that computed
  /// it, or with the problem of `stopped_problem`, on the thread that stopped the interest; it is destroyed then, also
  /// when it throws. Null, and nothing is told, when the queue is full.
  template <class T>
  std::shared_ptr<Interest> ask(const Terms& terms, std::function<Result<std::shared_ptr<const T>>(const Job&)> work,
                                std::function<void(const Result<std::shared_ptr<const T>>&, Begun)> tell) {
    return ask_any(
        terms,
        [work = std::move(work)](const Job& job) -> Outcome {
          auto outcome = work(job);
          if (!outcome) return std::move(outcome).problems();
          return std::shared_ptr<const void>(*std::move(outcome));
        },
        [tell = std::move(tell)](const Outcome& outcome, Begun begun) {
          if (!outcome) return tell(outcome.problems(), begun);
          tell(std::static_pointer_cast<const T>(*outcome), begun);
        });
  }

  /// Stops every interest there is.
  void stop_all(StopReason reason);

  Alarms& alarms() { return alarms_; }

  /// How many works were begun, and how many askers joined one.
  struct Count {
    std::size_t begun = 0;
    std::size_t joined = 0;
  };
  Count count() const;

 private:
  using Work = std::function<Outcome(const Job&)>;

  std::shared_ptr<Interest> ask_any(const Terms& terms, Work work, std::function<void(const Outcome&, Begun)> tell);
  bool admitted(const std::shared_ptr<ComputeQueue::Task>& task);
  void fly(Flight& flight);
  void leave(const std::shared_ptr<Interest>& interest, StopReason reason);
  static void tell(Interest& interest, const Outcome& outcome, Begun begun);

  ComputeQueue& queue_;
  Alarms& alarms_;
  const Outcome out_of_memory_;  ///< made while there is memory
  mutable std::mutex mutex_;
  std::condition_variable landed_;
  std::size_t flying_ = 0;
  std::map<Digest, std::shared_ptr<Flight>> flights_;
  Count count_;
};

}  // namespace dini::jobs

#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "jobs/alarms.h"
#include "jobs/flights.h"
#include "jobs/job_request.h"
#include "jobs/sweep.h"
#include "store/job_store.h"

namespace dini::jobs {

/// How a job is at a moment.
struct JobStatus {
  store::JobRecord record;
  double progress = 0;  ///< from 0 to 1; never goes back while the process runs
  Json best = nullptr;  ///< of a fit that runs, what it has found so far
};

/// Does the jobs that are kept, a few at once and in the order in which they came, also those that an earlier process
/// left: an evaluation or a fit begins again, a sweep goes on with the first variant that has no line.
class JobRunner {
 public:
  struct Terms {
    std::size_t at_once = 1;
    std::size_t most_waiting = 1000;
    std::chrono::milliseconds deadline{600'000};        ///< for one evaluation
    std::chrono::milliseconds result_time{86'400'000};  ///< how long what came of a job is kept
  };

  JobRunner(const Engine& engine, Flights& flights, Sweeps& sweeps, store::JobStore jobs, const Terms& terms);
  ~JobRunner();
  JobRunner(const JobRunner&) = delete;
  JobRunner& operator=(const JobRunner&) = delete;

  /// Begins to do what there is to do. To be called once, before anybody may add a job.
  void start();

  /// Keeps a job, and does it when it is its turn. Nothing when too many wait.
  Result<std::optional<store::AddedJob>> add(const store::NewJob& job);

  Result<std::optional<JobStatus>> find(const std::string& id) const;

  /// Stops a job, or takes it back before it begins; what has ended stays as it is. Nothing for none of that id.
  Result<std::optional<JobStatus>> cancel(const std::string& id);

  const store::JobStore& kept() const { return jobs_; }

  /// How many are done at this moment, and how many wait.
  struct Load {
    std::size_t running = 0;
    std::size_t waiting = 0;
  };
  Load load() const;

  /// Somebody who is told that a job may have changed, on any thread, until it is destroyed. `changed` must be quick
  /// and must not destroy it.
  class Watch {
   public:
    Watch(JobRunner& runner, std::string id, std::function<void()> changed);
    ~Watch();
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

   private:
    friend class JobRunner;
    JobRunner& runner_;
    const std::string id_;
    const std::function<void()> changed_;
    std::list<Watch*>::iterator place_;
  };

  /// Begins no more jobs and changes none: what is stopped from now on is left for the next process.
  void stop();
  bool is_stopped() const;

 private:
  using Clock = Alarms::Clock;
  class SweepTaker;
  struct Live;
  struct Ending;
  using SharedLive = std::shared_ptr<Live>;

  void work();
  void begin(const std::string& id, const SharedLive& live);
  void evaluate(const std::string& id, const SharedLive& live, const EvaluateRequest& request, Clock::duration limit);
  void fit(const std::string& id, const SharedLive& live, FitRequest request, Clock::duration limit);
  void sweep(const std::string& id, const SharedLive& live, SweepRequest request, Clock::duration limit);
  template <class Ask>
  void ask_until_admitted(const std::string& id, const SharedLive& live, Ask ask);
  void end_with(const std::string& id, const Problems& problems);
  void end(const std::string& id, Ending ending);
  bool write_end(const std::string& id, const Ending& ending);
  void write_late_ends();
  JobStatus status_of(store::JobRecord record) const;
  void tell(const std::string& id);
  void tick();

  const Engine& engine_;
  Flights& flights_;
  Sweeps& sweeps_;
  store::JobStore jobs_;
  const Terms terms_;
  mutable std::mutex mutex_;  ///< of what follows
  std::condition_variable changed_;
  std::deque<std::string> waiting_;
  std::map<std::string, SharedLive> live_;
  bool stopped_ = false;
  std::mutex watching_;  ///< of the watches; held while they are told, so none is told once it is destroyed
  std::list<Watch*> watches_;
  bool ticks_ = false;
  Alarms::Alarm ticking_;
  std::thread thread_;  ///< begins jobs, and lets go of old ones
};

}  // namespace dini::jobs

#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "jobs/flights.h"
#include "jobs/sweep.h"

namespace dini::jobs {

/// Evaluates variants with all threads and tells how they fared in their order. It gives its place to compute up after
/// every slice, so that nobody waits behind a long sweep, and while its taker has no room.
class LocalSweep final : public Sweep, public std::enable_shared_from_this<LocalSweep> {
 public:
  LocalSweep(const Engine& engine, Flights& flights, SweepRequest request, const SweepCost& cost,
             std::unique_ptr<LineTaker> taker, std::string base_path);

  void start() override { go_on(); }
  void stop(StopReason reason) override;

 private:
  using Clock = Alarms::Clock;

  void go_on();
  Result<std::shared_ptr<const bool>> run_slice(const Job& job);
  void slice_told(const Result<std::shared_ptr<const bool>>& outcome);
  void end(const Problems& reasons);

  const Engine& engine_;
  Flights& flights_;
  const SweepRequest request_;
  const SweepCost cost_;
  const Digest name_;
  const std::string base_path_;
  const std::unique_ptr<LineTaker> taker_;
  std::mutex taking_;   ///< of what is told, and of what follows
  std::size_t next_;    ///< the first variant that was not told
  bool wanted_ = true;  ///< its taker wants more
  bool ended_ = false;
  std::mutex mutex_;  ///< of what follows
  std::shared_ptr<Flights::Interest> interest_;
  Alarms::Alarm again_;
  bool over_ = false;
};

/// Sweeps that are computed here. They are stopped with all other flights.
class LocalSweeps final : public Sweeps {
 public:
  /// The addresses in lines begin with `base_path`.
  LocalSweeps(const Engine& engine, Flights& flights, std::string base_path)
      : engine_(engine), flights_(flights), base_path_(std::move(base_path)) {}

  Result<std::shared_ptr<Sweep>> make(const SweepRequest& request, const SweepCost& cost,
                                      std::unique_ptr<LineTaker> taker, Waiting) override {
    return std::shared_ptr<Sweep>(
        std::make_shared<LocalSweep>(engine_, flights_, request, cost, std::move(taker), base_path_));
  }
  void stop_all(StopReason) override {}
  void finish() override {}

 private:
  const Engine& engine_;
  Flights& flights_;
  const std::string base_path_;
};

}  // namespace dini::jobs

#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "jobs/alarms.h"
#include "jobs/flights.h"
#include "service/engine.h"
#include "service/variants.h"

namespace dini::jobs {

/// What a sweep asks of the engine: one request for many settings of its parameters.
struct SweepRequest {
  EvaluateRequest base;
  Variants variants;
  std::vector<std::string> outputs = {};  ///< that each variant is evaluated for; empty: what `base` says
  std::size_t first = 0;                  ///< the variant to begin with
  Alarms::Clock::time_point deadline = Alarms::Clock::time_point::max();

  /// The request of the variant with these values, for one of the outputs.
  EvaluateRequest with(const Json& setting, const std::string& output) const;
  /// The outputs that a variant is evaluated for.
  std::vector<std::string> outputs_of_variant() const;
};

/// What is known of a sweep before it begins.
struct SweepCost {
  std::size_t work = 0;   ///< predicted nanoseconds of one processor, as if its variants and outputs shared nothing
  std::size_t bytes = 0;  ///< predicted memory of the largest variant, with all of its outputs
};

/// Checks every variant. Those that are wrong cost nothing and are told when it is their turn; a sweep over the limit
/// is a problem.
Result<std::shared_ptr<const SweepCost>> predict(const Engine& engine, const SweepRequest& request, const Job& job);

/// How one output of a variant fared.
struct OutputOutcome {
  std::string output;  ///< as the request has it: empty for the only one
  Result<SharedPrepared> prepared;
  Result<SharedComputed> computed;  ///< the problems of preparing where there are some
};

/// How one variant fared.
struct VariantOutcome {
  std::size_t index = 0;
  Json setting;                        ///< its values by parameter
  bool lists_outputs = false;          ///< the request does
  std::vector<OutputOutcome> outputs;  ///< at least one, as they were asked for; one that failed stops no other

  bool failed() const;
  /// The problems of all outputs, each once.
  Problems problems() const;
  /// The models that were made.
  std::vector<SharedFile> files() const;
};

/// How many variants `evaluate_in_order` holds at once at the most: one for each thread, and one that is done and waits
/// for an earlier one.
std::size_t most_at_once();

/// Evaluates variants from that one on, with all threads, and hands on how they fared, in their order and one at a
/// time, on any thread. No further one is begun once `go_on` says no or the job is stopped; those that were begun are
/// handed on.
void evaluate_in_order(const Engine& engine, const SweepRequest& request, std::size_t first, const Job& job,
                       const std::function<bool()>& go_on, const std::function<void(const VariantOutcome&)>& hand_on);

/// Evaluates variants with all threads and tells how they fared in their order. It gives its place to compute up after
/// every slice, so that nobody waits behind a long sweep, and while its taker has no room.
class Sweep : public std::enable_shared_from_this<Sweep> {
 public:
  /// Whoever is told. One call at a time, on a thread that computes but for `end`, which may be on any.
  class Taker {
   public:
    virtual ~Taker() = default;
    /// False when nobody wants any more.
    virtual bool take(const VariantOutcome& outcome) = 0;
    /// Whether to go on now; if not, `resume` is called once there is room.
    virtual bool has_room(std::function<void()> resume) = 0;
    /// All were told, or there are reasons why not: then `next` is the first one that was not.
    virtual void end(const Problems& reasons, std::size_t next) = 0;
  };

  Sweep(const Engine& engine, Flights& flights, SweepRequest request, const SweepCost& cost,
        std::unique_ptr<Taker> taker);

  /// Begins it. It lives until it has ended.
  void start() { go_on(); }
  void stop(StopReason reason);

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
  const std::unique_ptr<Taker> taker_;
  std::mutex taking_;   ///< of what is told, and of what follows
  std::size_t next_;    ///< the first variant that was not told
  bool wanted_ = true;  ///< its taker wants more
  bool ended_ = false;
  std::mutex mutex_;  ///< of what follows
  std::shared_ptr<Flights::Interest> interest_;
  Alarms::Alarm again_;
  bool over_ = false;
};

}  // namespace dini::jobs

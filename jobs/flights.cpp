#include "jobs/flights.h"

#include <new>

#include "graph/stopped.h"

namespace dini::jobs {

/// One work and everybody who is interested in it. All members but `job` and what `work` does belong to the lock of
/// the flights.
class Flights::Flight {
 public:
  Digest key{};
  Job job;
  Work work;
  std::shared_ptr<ComputeQueue::Task> task;
  std::list<std::shared_ptr<Interest>> interests;
  Begun begun;
};

namespace {

Problem bug() { return {"internal", "something went wrong while this was computed"}; }

}  // namespace

Flights::Flights(ComputeQueue& queue, Alarms& alarms)
    : queue_(queue), alarms_(alarms), out_of_memory_(out_of_memory()) {}

Flights::~Flights() {
  stop_all(StopReason::shutting_down);
  std::unique_lock lock(mutex_);
  landed_.wait(lock, [this] { return flying_ == 0; });
}

std::shared_ptr<Flights::Interest> Flights::ask_any(const Terms& terms, Work work,
                                                    std::function<void(const Outcome&, Begun)> tell) {
  auto interest = std::make_shared<Interest>();
  interest->flights_ = this;
  interest->tell_ = std::move(tell);
  const std::weak_ptr<Interest> weak = interest;
  std::list<std::shared_ptr<Interest>> joining = {interest};
  auto fresh = std::make_shared<Flight>();
  fresh->key = terms.key;
  fresh->work = std::move(work);
  const auto run = [this, flight = std::weak_ptr<Flight>(fresh)] {
    if (const auto flying = flight.lock()) fly(*flying);  // else there are no flights any more
  };
  fresh->task = std::make_shared<ComputeQueue::Task>(terms.bytes, run, terms.work);
  if (terms.deadline != Clock::time_point::max()) {
    interest->deadline_ = alarms_.at(terms.deadline, [weak] {
      if (const auto late = weak.lock()) late->stop(StopReason::deadline);
    });
  }
  const std::lock_guard lock(mutex_);
  if (interest->told_) return interest;  // its deadline has passed already
  const auto [place, first] = flights_.try_emplace(terms.key, fresh);
  if (first && !admitted(fresh->task)) {
    flights_.erase(place);
    interest->told_ = true;  // not to be told by its alarm either
    interest->tell_ = nullptr;
    return nullptr;
  }
  ++(first ? count_.begun : count_.joined);
  interest->flight_ = place->second;
  interest->place_ = joining.begin();
  place->second->interests.splice(place->second->interests.end(), joining);
  return interest;
}

/// Whether the queue takes a task; for want of memory it takes none.
bool Flights::admitted(const std::shared_ptr<ComputeQueue::Task>& task) {
  try {
    return queue_.add(task);
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void Flights::Interest::stop(StopReason reason) { flights_->leave(shared_from_this(), reason); }

bool Flights::Interest::has_begun() const {
  const std::lock_guard lock(flights_->mutex_);
  return flight_ != nullptr && flight_->begun.has_value();
}

Progress::State Flights::Interest::progress() const {
  const std::lock_guard lock(flights_->mutex_);
  return flight_ != nullptr ? flight_->job.progress.state() : Progress::State{};
}

void Flights::leave(const std::shared_ptr<Interest>& interest, StopReason reason) {
  std::shared_ptr<Flight> left;
  Begun begun;
  {
    const std::lock_guard lock(mutex_);
    if (interest->told_) return;
    interest->told_ = true;
    if (const std::shared_ptr<Flight> flight = std::move(interest->flight_)) {
      begun = flight->begun;
      flight->interests.erase(interest->place_);
      if (flight->interests.empty()) {
        flight->job.cancel.stop(reason);
        // Whoever asks from now on wants what this work will not give.
        flights_.erase(flight->key);
        left = flight;
      }
    }
  }
  if (left) queue_.withdraw(left->task);
  try {
    tell(*interest, stopped_problem(reason), begun);
  } catch (const std::bad_alloc&) {
    tell(*interest, out_of_memory_, begun);
  }
}

void Flights::fly(Flight& flight) {
  {
    const std::lock_guard lock(mutex_);
    flight.begun = Clock::now();
    ++flying_;
  }
  std::shared_ptr<const Outcome> outcome(std::shared_ptr<void>(), &out_of_memory_);
  try {
    outcome = std::make_shared<const Outcome>(flight.work(flight.job));
  } catch (const std::bad_alloc&) {
    // stays as it is
  } catch (...) {
    try {
      outcome = std::make_shared<const Outcome>(bug());
    } catch (const std::bad_alloc&) {
      // stays as it is
    }
  }
  std::list<std::shared_ptr<Interest>> interests;
  std::shared_ptr<Flight> landed;
  {
    const std::lock_guard lock(mutex_);
    interests.swap(flight.interests);
    for (const auto& interest : interests) {
      interest->told_ = true;
      interest->flight_ = nullptr;
    }
    // One that was stopped may have been followed by another of the same key.
    const auto place = flights_.find(flight.key);
    if (place != flights_.end() && place->second.get() == &flight) {
      landed = std::move(place->second);
      flights_.erase(place);
    }
  }
  for (const auto& interest : interests) tell(*interest, *outcome, flight.begun);
  const std::lock_guard lock(mutex_);
  --flying_;
  landed_.notify_all();
}

void Flights::tell(Interest& interest, const Outcome& outcome, Begun begun) {
  const std::function<void(const Outcome&, Begun)> telling = std::move(interest.tell_);
  if (!telling) return;
  try {
    telling(outcome, begun);
  } catch (...) {
    // What it holds is destroyed now, which is how those behind it learn that there is no telling.
  }
}

void Flights::stop_all(StopReason reason) {
  std::list<std::shared_ptr<Interest>> all;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [key, flight] : flights_)
      all.insert(all.end(), flight->interests.begin(), flight->interests.end());
  }
  for (const auto& interest : all) interest->stop(reason);
}

Flights::Count Flights::count() const {
  const std::lock_guard lock(mutex_);
  return count_;
}

}  // namespace dini::jobs

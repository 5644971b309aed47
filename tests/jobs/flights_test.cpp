#include "jobs/flights.h"

#include <catch2/catch.hpp>
#include <future>
#include <latch>
#include <new>
#include <stdexcept>
#include <vector>

#include "tests/support/eventually.h"

using namespace dini;
using namespace dini::jobs;
using namespace std::chrono_literals;
using dini::support::eventually;

namespace {

using Answer = Result<std::shared_ptr<const int>>;

Answer value(int number) { return std::make_shared<const int>(number); }

/// What one asker was told, and how often.
struct Told {
  std::atomic<int> times = 0;
  std::string code;
  int number = 0;
  bool had_begun = false;

  auto teller() {
    return [this](const Answer& answer, Flights::Begun begun) {
      if (answer) number = **answer;
      if (!answer) code = answer.problems().front().code;
      had_begun = begun.has_value();
      ++times;
    };
  }
  bool wait() {
    return eventually([this] { return times > 0; });
  }
};

struct FlightField {
  explicit FlightField(std::size_t places = 1, std::size_t waiting = 4) : queue({places, waiting, 1000}) {}
  Alarms alarms;
  ComputeQueue queue;
  Flights flights{queue, alarms};

  auto ask(std::uint8_t key, std::function<Answer(const Job&)> work, Told& told,
           Flights::Clock::time_point deadline = Flights::Clock::time_point::max()) {
    return flights.ask<int>({.key = {key}, .deadline = deadline}, std::move(work), told.teller());
  }
};

/// Work that ends when it is stopped or let go.
std::function<Answer(const Job&)> until(std::atomic<bool>& go, std::atomic<int>& runs, std::atomic<int>& stopped) {
  return [&](const Job& job) -> Answer {
    ++runs;
    eventually([&] { return go || job.cancel.stopped(); });
    if (job.cancel.stopped()) ++stopped;
    return value(7);
  };
}

}  // namespace

TEST_CASE("A hundred who ask for the same are told the same, after one computation in one place") {
  FlightField field(1, 0);
  std::atomic<bool> go = false;
  std::atomic<int> runs = 0, stopped = 0;
  std::vector<Told> told(100);
  for (Told& one : told) REQUIRE(field.ask(1, until(go, runs, stopped), one) != nullptr);
  go = true;
  for (Told& one : told) {
    REQUIRE(one.wait());
    CHECK(one.number == 7);
    CHECK(one.times == 1);
  }
  CHECK(runs == 1);
  CHECK(field.flights.count().begun == 1);
  CHECK(field.flights.count().joined == 99);
}

TEST_CASE("Who is not let in is not told") {
  FlightField field(1, 0);
  std::atomic<bool> go = false;
  std::atomic<int> runs = 0, stopped = 0;
  Told first, second;
  REQUIRE(field.ask(1, until(go, runs, stopped), first));
  CHECK(field.ask(2, until(go, runs, stopped), second, Flights::Clock::now() + 10ms) == nullptr);
  go = true;
  REQUIRE(first.wait());
  std::atomic<bool> past_its_deadline = false;
  const auto later = field.alarms.at(Flights::Clock::now() + 20ms, [&] { past_its_deadline = true; });
  REQUIRE(eventually([&] { return past_its_deadline.load(); }));
  CHECK(second.times == 0);
  Told third;
  REQUIRE(eventually([&] { return field.queue.load().running == 0; }));
  CHECK(field.ask(2, until(go, runs, stopped), third));
  CHECK(third.wait());
}

TEST_CASE("One who leaves is told why at once, and the work goes on for the others and ends with the last") {
  FlightField field;
  std::atomic<bool> go = false;
  std::atomic<int> runs = 0, stopped = 0;
  Told first, second, third;
  const auto a = field.ask(1, until(go, runs, stopped), first);
  const auto b = field.ask(1, until(go, runs, stopped), second);
  REQUIRE(eventually([&] { return runs == 1; }));
  a->stop(StopReason::client_gone);
  CHECK(first.times == 1);
  CHECK(first.code == "client-gone");
  CHECK(first.had_begun);
  CHECK(stopped == 0);
  CHECK(second.times == 0);
  b->stop(StopReason::superseded);
  CHECK(second.code == "superseded");
  CHECK(eventually([&] { return stopped == 1; }));
  // A work that was stopped is not joined any more.
  const auto c = field.ask(1, until(go, runs, stopped), third);
  REQUIRE(eventually([&] { return runs == 2; }));
  go = true;
  REQUIRE(third.wait());
  CHECK(third.number == 7);
  b->stop(StopReason::deadline);
  CHECK(second.times == 1);
}

TEST_CASE("Deadlines hold for those who wait in the queue, and take back their work") {
  FlightField field(1, 2);
  std::atomic<bool> go = false;
  std::atomic<int> runs = 0, stopped = 0;
  Told running, waiting;
  const auto a = field.ask(1, until(go, runs, stopped), running);
  REQUIRE(eventually([&] { return runs == 1; }));
  const auto b = field.ask(2, until(go, runs, stopped), waiting, Flights::Clock::now() + 20ms);
  REQUIRE(waiting.wait());
  CHECK(waiting.code == "deadline");
  CHECK_FALSE(waiting.had_begun);
  CHECK(field.queue.load().waiting == 0);
  go = true;
  REQUIRE(running.wait());
  CHECK(runs == 1);
}

TEST_CASE("A deadline that has passed already is told like any other") {
  FlightField field;
  std::atomic<bool> go = true;
  std::atomic<int> runs = 0, stopped = 0;
  Told late;
  const auto interest = field.ask(1, until(go, runs, stopped), late, Flights::Clock::now() - 1ms);
  REQUIRE(late.wait());
  CHECK(late.times == 1);
}

TEST_CASE("Exceptions become problems and tell nothing of the inside") {
  FlightField field;
  Told memory, bug;
  field.ask(
      1, [](const Job&) -> Answer { throw std::bad_alloc(); }, memory);
  field.ask(
      2, [](const Job&) -> Answer { throw std::runtime_error("secret"); }, bug);
  REQUIRE(memory.wait());
  REQUIRE(bug.wait());
  CHECK(memory.code == "out-of-memory");
  CHECK(bug.code == "internal");
}

TEST_CASE("A teller that throws is destroyed and hurts nobody else") {
  FlightField field;
  const auto held = std::make_shared<int>(1);
  const std::weak_ptr<int> watch = held;
  Told other;
  std::atomic<bool> go = false;
  std::atomic<int> runs = 0, stopped = 0;
  std::function<void(const Answer&, Flights::Begun)> thrower =
      [keep = std::shared_ptr<int>(held)](const Answer&, Flights::Begun) { throw std::bad_alloc(); };
  field.flights.ask<int>({.key = {1}}, until(go, runs, stopped), std::move(thrower));
  thrower = nullptr;
  field.ask(1, until(go, runs, stopped), other);
  go = true;
  REQUIRE(other.wait());
  CHECK(eventually([&] { return held.use_count() == 1; }));
}

TEST_CASE("Everybody can be told that the server is shutting down") {
  FlightField field(2, 8);
  std::atomic<bool> go = false;
  std::atomic<int> runs = 0, stopped = 0;
  std::vector<Told> told(6);
  for (std::size_t i = 0; i < told.size(); ++i) {
    REQUIRE(field.ask(static_cast<std::uint8_t>(i), until(go, runs, stopped), told[i]));
  }
  field.flights.stop_all(StopReason::shutting_down);
  for (const Told& one : told) {
    CHECK(one.times == 1);
    CHECK(one.code == "shutting-down");
  }
}

TEST_CASE("Asking, leaving and landing at the same time tell everybody exactly once") {
  FlightField field(2, 1000);
  constexpr int askers = 4, rounds = 500;
  std::vector<Told> told(askers * rounds);
  {
    std::vector<std::jthread> threads;
    for (int asker = 0; asker < askers; ++asker) {
      threads.emplace_back([&, asker] {
        for (int round = 0; round < rounds; ++round) {
          Told& one = told[static_cast<std::size_t>(asker * rounds + round)];
          const auto interest = field.ask(
              static_cast<std::uint8_t>(round % 3), [](const Job&) { return value(1); }, one,
              round % 5 == 0 ? Flights::Clock::now() : Flights::Clock::time_point::max());
          if (interest == nullptr) one.times = 1;
          if (interest != nullptr && round % 2 == 0) interest->stop(StopReason::superseded);
        }
      });
    }
  }
  for (Told& one : told) {
    REQUIRE(one.wait());
    CHECK(one.times == 1);
  }
}

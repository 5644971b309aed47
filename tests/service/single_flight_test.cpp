#include "service/single_flight.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <latch>
#include <stdexcept>
#include <thread>

using namespace dini;

TEST_CASE("identical work never runs twice at the same time, and everybody gets its answer") {
  SingleFlight<int> flights;
  const Cancel cancel;
  constexpr int callers = 8;
  std::latch together(callers);
  std::atomic<int> running = 0, most = 0, answers = 0;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < callers; ++i) {
      threads.emplace_back([&] {
        together.arrive_and_wait();
        for (int round = 0; round < 200; ++round) {
          const int answer = flights.run("key", cancel, [&](const Cancel&) {
            most = std::max(most.load(), ++running);
            std::this_thread::yield();
            --running;
            return 7;
          });
          if (answer == 7) ++answers;
        }
      });
    }
  }
  CHECK(most == 1);
  CHECK(answers == callers * 200);
}

TEST_CASE("different work runs side by side") {
  SingleFlight<int> flights;
  const Cancel cancel;
  std::latch both(2);  // each waits for the other, so one after the other would never end
  const auto work = [&](const Cancel&) {
    both.arrive_and_wait();
    return 1;
  };
  std::jthread other([&] { flights.run("one", cancel, work); });
  CHECK(flights.run("two", cancel, work) == 1);
}

TEST_CASE("one who waits gives up when stopped, without the work being done for them") {
  SingleFlight<int> flights;
  const Cancel patient;
  std::atomic<bool> gave_up = false;
  const int answer = flights.run("key", patient, [&](const Cancel&) {
    std::jthread impatient([&] {
      const Cancel stopped;
      stopped.stop(StopReason::client_gone);
      gave_up = flights.run("key", stopped, [](const Cancel& cancel) { return cancel.stopped() ? -1 : 1; }) == -1;
    });
    return 5;
  });
  CHECK(answer == 5);
  CHECK(gave_up);
}

TEST_CASE("when the one who computes is stopped, one who waits computes anew") {
  SingleFlight<int> flights;
  const Cancel leaving, patient;
  std::jthread waiter;
  std::atomic<int> second = 0;
  const int first = flights.run("key", leaving, [&](const Cancel&) {
    waiter = std::jthread([&] { second = flights.run("key", patient, [](const Cancel&) { return 2; }); });
    leaving.stop(StopReason::superseded);
    return 1;
  });
  waiter.join();
  CHECK(first == 1);
  CHECK(second == 2);
}

TEST_CASE("work that throws leaves nobody waiting") {
  SingleFlight<int> flights;
  const Cancel cancel;
  CHECK_THROWS_AS(flights.run("key", cancel, [](const Cancel&) -> int { throw std::runtime_error("broken"); }),
                  std::runtime_error);
  CHECK(flights.run("key", cancel, [](const Cancel&) { return 3; }) == 3);
}

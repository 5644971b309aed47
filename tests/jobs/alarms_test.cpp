#include "jobs/alarms.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <optional>
#include <vector>

#include "tests/support/eventually.h"

using namespace dini::jobs;
using namespace std::chrono_literals;
using dini::support::eventually;

TEST_CASE("Alarms ring in the order of their times") {
  Alarms alarms;
  const auto now = Alarms::Clock::now();
  std::mutex mutex;
  std::vector<int> rung;
  const auto note = [&](int which) {
    return [&, which] {
      const std::lock_guard lock(mutex);
      rung.push_back(which);
    };
  };
  const auto late = alarms.at(now + 30ms, note(3));
  const auto early = alarms.at(now + 10ms, note(1));
  const auto middle = alarms.at(now + 20ms, note(2));
  CHECK(eventually([&] {
    const std::lock_guard lock(mutex);
    return rung == std::vector<int>{1, 2, 3};
  }));
}

TEST_CASE("An alarm that is taken back does not ring, and has rung to its end when that returns") {
  Alarms alarms;
  std::atomic<bool> rung = false;
  {
    const auto never = alarms.at(Alarms::Clock::now() + 1h, [&] { rung = true; });
  }
  CHECK_FALSE(rung);

  std::atomic<bool> begun = false, taken_back = false, ended = false;
  {
    const auto ringing = alarms.at(Alarms::Clock::now(), [&] {
      begun = true;
      eventually([&] { return taken_back.load(); });
      ended = true;
    });
    REQUIRE(eventually([&] { return begun.load(); }));
    taken_back = true;
  }
  CHECK(ended);
}

TEST_CASE("What rings may destroy its own alarm") {
  Alarms alarms;
  std::atomic<bool> done = false;
  std::mutex mutex;
  std::optional<Alarms::Alarm> own;
  {
    const std::lock_guard lock(mutex);
    own.emplace(alarms.at(Alarms::Clock::now(), [&] {
      const std::lock_guard inner(mutex);
      own.reset();
      done = true;
    }));
  }
  CHECK(eventually([&] { return done.load(); }));
}

#include "jobs/compute_queue.h"

#include <catch2/catch.hpp>
#include <latch>
#include <optional>

#include "tests/support/eventually.h"

using namespace dini::jobs;
using dini::support::eventually;

namespace {

std::shared_ptr<ComputeQueue::Task> task(std::function<void()> run, std::size_t bytes = 0,
                                         std::size_t work = ComputeQueue::unknown_work) {
  return std::make_shared<ComputeQueue::Task>(bytes, std::move(run), work);
}

}  // namespace

TEST_CASE("A queue gives its places, then lets a number wait, then refuses") {
  std::latch go(1);
  std::atomic<int> ran = 0;
  {
    ComputeQueue queue({.places = 2, .waiting = 3, .bytes = 100});
    const auto wait = [&] {
      go.wait();
      ++ran;
    };
    for (int i = 0; i < 5; ++i) REQUIRE(queue.add(task(wait)));
    CHECK_FALSE(queue.add(task(wait)));
    REQUIRE(eventually([&] { return queue.load().running == 2; }));
    CHECK(queue.load().waiting == 3);
    CHECK_FALSE(queue.add(task(wait)));
    go.count_down();
  }
  CHECK(ran == 5);
}

TEST_CASE("A free place is never refused, however quickly tasks follow each other") {
  ComputeQueue queue({.places = 1, .waiting = 0, .bytes = 100});
  std::atomic<int> ran = 0;
  for (int i = 0; i < 2000; ++i) {
    REQUIRE(queue.add(task([&] { ++ran; })));
    REQUIRE(eventually([&] {
      const ComputeQueue::Load load = queue.load();  // at one moment: it goes from waiting to running between two
      return load.running == 0 && load.waiting == 0;
    }));
  }
  CHECK(ran == 2000);
}

TEST_CASE("What waits can be taken back and then never runs, but what runs cannot") {
  std::latch go(1);
  std::atomic<bool> ran = false;
  {
    ComputeQueue queue({.places = 1, .waiting = 2, .bytes = 100});
    const auto first = task([&] { go.wait(); });
    const auto second = task([&] { ran = true; });
    REQUIRE(queue.add(first));
    REQUIRE(queue.add(second));
    REQUIRE(eventually([&] { return queue.load().running == 1; }));
    CHECK(queue.withdraw(second));
    CHECK_FALSE(queue.withdraw(second));
    CHECK_FALSE(queue.withdraw(first));
    CHECK(queue.load().waiting == 0);
    go.count_down();
  }
  CHECK_FALSE(ran);
}

TEST_CASE("Nothing starts before there is room for its memory, but what needs more than all runs alone") {
  std::mutex mutex;
  std::size_t held = 0, most = 0, alone = 0;
  {
    ComputeQueue queue({.places = 4, .waiting = 100, .bytes = 100});
    for (const std::size_t bytes : {60, 60, 30, 500, 90, 10, 40, 40, 20}) {
      REQUIRE(queue.add(task(
          [&, bytes] {
            {
              const std::lock_guard lock(mutex);
              held += bytes;
              if (bytes == 500) alone = held;
              if (bytes != 500) most = std::max(most, held);
            }
            for (int turn = 0; turn < 1000; ++turn) std::this_thread::yield();
            const std::lock_guard lock(mutex);
            held -= bytes;
          },
          bytes)));
    }
  }
  CHECK(most <= 100);
  CHECK(alone == 500);
}

TEST_CASE("A queue says once that it is idle, each time that something ran") {
  std::atomic<int> idle = 0, ran = 0;
  ComputeQueue queue({.places = 2, .waiting = 2, .bytes = 100}, [&] { ++idle; });
  for (int round = 1; round <= 2; ++round) {
    REQUIRE(queue.add(task([&] { ++ran; })));
    REQUIRE(eventually([&] { return ran == round && idle == round; }));
  }
  CHECK(idle == 2);
}

TEST_CASE("Beyond the queue those still wait whose turn comes soon") {
  constexpr std::size_t millisecond = 1'000'000;
  std::latch go(1);
  std::atomic<int> ran = 0;
  {
    ComputeQueue queue({.places = 1, .waiting = 1, .bytes = 100, .waiting_work = 10 * millisecond});
    const auto wait = [&] {
      go.wait();
      ++ran;
    };
    REQUIRE(queue.add(task(wait)));
    REQUIRE(eventually([&] { return queue.load().running == 1; }));
    REQUIRE(queue.add(task(wait, 0, 4 * millisecond)));
    CHECK_FALSE(queue.add(task(wait)));
    CHECK_FALSE(queue.add(task(wait, 0, 7 * millisecond)));
    const auto left = task(wait, 0, 6 * millisecond);
    CHECK(queue.add(left));
    CHECK_FALSE(queue.add(task(wait, 0, 1)));
    CHECK(queue.withdraw(left));
    // What is predicted to take no time counts all the same.
    for (int i = 0; i < 6; ++i) CHECK(queue.add(task(wait, 0, 0)));
    CHECK_FALSE(queue.add(task(wait, 0, 0)));
    go.count_down();
    REQUIRE(eventually([&] { return ran == 8; }));
    CHECK(queue.add(task(wait, 0, 10 * millisecond)));
  }
  CHECK(ran == 9);
}

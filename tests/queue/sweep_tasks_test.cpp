#include "queue/sweep_tasks.h"

#include <set>

#include "queue/dead_tasks.h"
#include "queue/scripts.h"
#include "queue/task_taker.h"
#include "tests/support/redis_server.h"

using namespace dini;
using queue::Lane;
using Submitted = queue::SweepTasks::Submitted;
using Finished = queue::TaskTaker::Finished;

namespace {

constexpr std::chrono::milliseconds at_once{0};
constexpr std::chrono::milliseconds soon_silent{1};

/// A server's end and what workers need, of one identity.
struct Bench {
  support::RedisServer redis;
  queue::SweepTasks tasks{redis.address(), {}, "1-a"};

  queue::TaskTaker worker(const std::string& name, std::chrono::milliseconds silence = std::chrono::seconds(15),
                          const std::string& identity = "1-a") const {
    queue::TaskTaker taker(redis.address(), {}, {.identity = identity, .worker = name + "/1", .silence = silence});
    REQUIRE(taker.beat({}));
    return taker;
  }
  void submit(const std::string& id, std::size_t total, Lane lane = Lane::batch) {
    const auto submitted =
        tasks.submit({.id = id, .lane = lane, .body = "body of " + id, .about = "{}", .total = total}, {});
    REQUIRE(submitted);
    REQUIRE(*submitted == Submitted::taken);
    REQUIRE(tasks.collect(id, total, {}));
  }
  std::vector<queue::CollectedLine> collect(const std::string& id, const std::vector<std::size_t>& have = {}) {
    const auto collected = tasks.collect(id, 1000, have);
    REQUIRE(collected);
    return collected->lines;
  }
};

std::optional<queue::Task> take(queue::TaskTaker& taker) {
  const auto taken = taker.take(at_once);
  REQUIRE(taken);
  return *taken;
}

/// Longer than what goes through scripts.
const std::string long_line(100'000, 'l');

}  // namespace

TEST_CASE("Each variant of a sweep is given to one worker, and its line comes back once") {
  Bench bench;
  auto one = bench.worker("one"), two = bench.worker("two");
  bench.submit("s", 7);
  std::set<std::size_t> taken, told;
  for (std::size_t i = 0; i < 7; ++i) {
    queue::TaskTaker& worker = i % 2 == 0 ? one : two;
    const auto task = take(worker);
    REQUIRE(task);
    CHECK(taken.insert(task->index).second);
    CHECK((*worker.find("s"))->body == "body of s");
    CHECK(*worker.finish(*task, "line " + std::to_string(task->index)) == Finished::counted);
    CHECK(*worker.finish(*task, "another line") == Finished::twice);
  }
  CHECK_FALSE(take(one));
  for (const queue::CollectedLine& line : bench.collect("s")) {
    CHECK(line.line == "line " + std::to_string(line.index));
    told.insert(line.index);
  }
  CHECK(told.size() == 7);
  CHECK(bench.collect("s", {told.begin(), told.end()}).empty());
}

TEST_CASE("Variants that somebody waits for go before those of jobs") {
  Bench bench;
  auto worker = bench.worker("one");
  bench.submit("later", 2);
  bench.submit("now", 1, Lane::interactive);
  CHECK(take(worker)->sweep == "now");
  CHECK(take(worker)->sweep == "later");
}

TEST_CASE("Workers of another engine are given nothing") {
  Bench bench;
  auto ours = bench.worker("ours");
  auto other = bench.worker("other", std::chrono::seconds(15), "2-a");
  bench.submit("s", 1);
  CHECK_FALSE(take(other));
  CHECK(take(ours));
}

TEST_CASE("A sweep is not taken where no worker is, and not past as many as may be") {
  Bench bench;
  CHECK(*bench.tasks.submit({.id = "s", .total = 1}, {}) == Submitted::unmanned);
  auto worker = bench.worker("one");
  Submitted last = Submitted::taken;
  std::size_t count = 0;
  for (; count < 1000 && last == Submitted::taken; ++count) {
    last = *bench.tasks.submit({.id = std::to_string(count), .total = 1}, {});
  }
  CHECK(last == Submitted::full);
  CHECK(count == 257);
  CHECK(*bench.tasks.submit({.id = "0", .total = 1}, {}) == Submitted::taken);
}

TEST_CASE("What a silent worker has goes to another, whose heartbeat keeps it") {
  Bench bench;
  auto silent = bench.worker("silent");
  auto quick = bench.worker("quick", soon_silent);
  bench.submit("s", 1);
  const auto first = take(silent);
  REQUIRE(first);
  std::optional<queue::Task> second;
  REQUIRE(support::eventually([&] { return (second = take(quick)).has_value(); }));
  CHECK(second->index == first->index);
  CHECK(second->deliveries == 2);
  CHECK(silent.beat({*first})->size() == 1);  // it is told to stop
  CHECK(quick.beat({*second})->empty());
  CHECK(*silent.finish(*first, "line") == Finished::counted);
  CHECK(*quick.finish(*second, "line") == Finished::twice);
  CHECK(bench.collect("s").size() == 1);
}

TEST_CASE("A variant that ends three workers is dead, listed, and tried again when that is asked for") {
  Bench bench;
  auto first = bench.worker("first"), second = bench.worker("second", soon_silent),
       third = bench.worker("third", soon_silent), fourth = bench.worker("fourth", soon_silent);
  bench.submit("s", 1);
  CHECK(take(first)->deliveries == 1);
  const auto taken = [](queue::TaskTaker& worker) {
    std::optional<queue::Task> task;
    CHECK(support::eventually([&] { return (task = take(worker)).has_value(); }));
    return task.value_or(queue::Task{}).deliveries;
  };
  CHECK(taken(second) == 2);
  CHECK(taken(third) == 3);
  std::vector<queue::CollectedLine> lines;
  CHECK(support::eventually([&] { return !take(fourth) && !(lines = bench.collect("s")).empty(); }));
  REQUIRE(lines.size() == 1);
  CHECK(lines.front().is_dead);

  queue::Connection connection(bench.redis.address(), {});
  const auto dead = queue::dead_tasks(connection);
  REQUIRE(dead);
  REQUIRE(dead->size() == 1);
  CHECK(dead->front().index == "0");
  CHECK(dead->front().worker == "third/1");
  CHECK(queue::queue_states(connection)->front().dead == 1);

  // The same request is not given to anybody else for a while.
  REQUIRE(bench.tasks.submit({.id = "t", .body = "body of s", .about = "{}", .total = 1}, {}));
  lines = bench.collect("t");
  REQUIRE(lines.size() == 1);
  CHECK(lines.front().is_dead);

  CHECK(*queue::retry(connection, "1-1") == queue::Retried::none);
  CHECK(*queue::retry(connection, dead->front().entry) == queue::Retried::again);
  CHECK(take(first));
  CHECK(queue::dead_tasks(connection)->empty());
  CHECK_FALSE(*queue::drop_dead(connection, dead->front().entry));
}

TEST_CASE("A sweep that is dropped is computed by nobody any more") {
  Bench bench;
  auto worker = bench.worker("one");
  bench.submit("s", 3);
  const auto task = take(worker);
  REQUIRE(task);
  REQUIRE(bench.tasks.drop("s"));
  CHECK(worker.beat({*task})->size() == 1);
  CHECK_FALSE(take(worker));
  CHECK(*worker.finish(*task, "line") == Finished::unwanted);
  CHECK(bench.tasks.collect("s", 3, {})->gone);
}

TEST_CASE("A Redis that lost everything is given the rest of a sweep again, and only that") {
  Bench bench;
  auto worker = bench.worker("one");
  bench.submit("s", 5);
  bench.redis.call({"FLUSHALL"});
  CHECK(bench.tasks.collect("s", 5, {})->gone);
  CHECK_FALSE(take(worker));
  REQUIRE(worker.beat({}));
  CHECK(*bench.tasks.submit({.id = "s", .total = 5, .first = 2}, {3}) == Submitted::taken);
  bench.collect("s");
  CHECK(take(worker)->index == 2);
  CHECK(take(worker)->index == 4);
  CHECK_FALSE(take(worker));
}

TEST_CASE("A line lives as long as its sweep, and nothing of it stays behind") {
  Bench bench;
  auto worker = bench.worker("one");
  bench.submit("s", 2);
  const std::string line = queue::place_of_line("dini:1-a", "s", 0);
  const auto left = [&](const std::string& key) { return bench.redis.call({"PTTL", key}).number; };
  const auto first = take(worker), second = take(worker);
  REQUIRE(worker.finish(*first, long_line));
  CHECK(left(line) > 1000);
  for (const std::string& key : {std::string("dini:1-a:sweep:s"), line}) bench.redis.call({"PEXPIRE", key, "1000"});
  CHECK(bench.collect("s").size() == 1);
  CHECK(left(line) > 1000);
  CHECK(bench.collect("s", {0}).empty());
  CHECK(left(line) == -2);

  REQUIRE(worker.finish(*second, long_line));
  REQUIRE(bench.tasks.drop("s"));
  CHECK(*worker.finish(*second, "late") == Finished::unwanted);
  CHECK(bench.redis.call({"EVAL", "return #redis.call('KEYS', '*:line*')", "0"}).number == 0);
}

TEST_CASE("A line that got lost is told as one, and made again when it is asked for") {
  Bench bench;
  auto worker = bench.worker("one");
  bench.submit("s", 1);
  REQUIRE(worker.finish(*take(worker), long_line));
  bench.redis.call({"DEL", queue::place_of_line("dini:1-a", "s", 0)});
  const auto lost = bench.collect("s");
  REQUIRE(lost.size() == 1);
  CHECK(lost.front().line.empty());
  CHECK_FALSE(lost.front().is_dead);
  REQUIRE(bench.tasks.redo("s", 0));
  REQUIRE(worker.finish(*take(worker), long_line));
  CHECK(bench.collect("s").front().line == long_line);
}

TEST_CASE("Whoever tells a line can have the next variant with the same answer") {
  Bench bench;
  auto worker = bench.worker("one");
  bench.submit("s", 3);
  using Then = queue::TaskTaker::Then;
  bench.redis.call({"SCRIPT", "FLUSH"});
  CHECK(*worker.finish(*take(worker), "line", Then::take) == Finished::counted);
  CHECK(*worker.finish(*take(worker), long_line, Then::take) == Finished::counted);
  REQUIRE(worker.has_next());
  const auto last = take(worker);
  REQUIRE(last);
  CHECK(last->index == 2);
  CHECK_FALSE(worker.has_next());
  CHECK(*worker.finish(*last, "line", Then::take) == Finished::counted);
  CHECK_FALSE(worker.has_next());
  CHECK(bench.collect("s").size() == 3);
}

TEST_CASE("A long line that Redis had no memory for is not counted") {
  Bench bench;
  auto worker = bench.worker("one");
  bench.submit("s", 1);
  const auto task = take(worker);
  bench.redis.call({"CONFIG", "SET", "maxmemory", "1"});
  const auto refused = worker.finish(*task, long_line);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().kind == queue::Fault::Kind::full);
  bench.redis.call({"CONFIG", "SET", "maxmemory", "0"});
  queue::Connection connection(bench.redis.address(), {});
  const auto without =
      connection.run(queue::scripts::finish, {}, {"dini:1-a", task->lane, task->entry, "s", "0", "long"});
  CHECK(without->text == "absent");
  CHECK(bench.collect("s").empty());
  CHECK(*worker.finish(*task, long_line) == Finished::counted);
  CHECK(bench.collect("s").front().line == long_line);
}

TEST_CASE("Of a large sweep only a few variants wait at a time") {
  Bench bench;
  auto worker = bench.worker("one");
  const auto submitted = bench.tasks.submit({.id = "s", .body = "b", .about = "{}", .total = 1'000'000}, {});
  REQUIRE(submitted);
  REQUIRE(bench.tasks.collect("s", 1'000'000, {}));
  CHECK(bench.redis.call({"XLEN", "dini:1-a:batch"}).number <= 16);
  const auto task = take(worker);
  REQUIRE(worker.finish(*task, "line"));
  REQUIRE(bench.tasks.collect("s", 1'000'000, {}));
  CHECK(take(worker));
}

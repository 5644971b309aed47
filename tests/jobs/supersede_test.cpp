#include "jobs/supersede.h"

#include <catch2/catch.hpp>

#include "tests/support/eventually.h"

using namespace dini;
using namespace dini::jobs;
using namespace std::chrono_literals;
using dini::support::eventually;

namespace {

using Answer = Result<std::shared_ptr<const int>>;

struct SupersedeField {
  Alarms alarms;
  ComputeQueue queue{{1, 16, 1000}};
  Flights flights{queue, alarms};
  Supersede registry;
  std::atomic<bool> go = false;
  Flights::Clock::time_point start = Flights::Clock::now();
  std::uint8_t keys = 0;

  ~SupersedeField() { go = true; }

  std::shared_ptr<Flights::Interest> ask(std::string& code) {
    return flights.ask<int>(
        {.key = {++keys}},
        [this](const Job& job) -> Answer {
          eventually([&] { return go || job.cancel.stopped(); });
          return std::make_shared<const int>(1);
        },
        [&code](const Answer& answer, Flights::Begun) { code = answer ? "done" : answer.problems().front().code; });
  }
};

}  // namespace

TEST_CASE("Only the same key supersedes, and only what arrived before") {
  std::string a, b, c, d;
  SupersedeField field;
  const auto first = field.ask(a), other = field.ask(b), anonymous = field.ask(c), second = field.ask(d);
  field.registry.take_over("k", field.start, first);
  field.registry.take_over("other", field.start, other);
  field.registry.take_over("", field.start, anonymous);
  field.registry.take_over("", field.start + 1ms, nullptr);
  CHECK(a.empty());
  field.registry.take_over("k", field.start + 1ms, second);
  CHECK(a == "superseded");
  CHECK(b.empty());
  CHECK(c.empty());
  CHECK(d.empty());
  field.registry.take_over("k", field.start + 2ms, nullptr);
  CHECK(d == "superseded");
}

TEST_CASE("A request that took longer to be read than a newer one is the superseded one") {
  std::string newer, older;
  SupersedeField field;
  const auto quick = field.ask(newer), slow = field.ask(older);
  field.registry.take_over("k", field.start + 1ms, quick);
  field.registry.take_over("k", field.start, slow);
  CHECK(newer.empty());
  CHECK(older == "superseded");
}

TEST_CASE("After the current one: what runs is finished, what waits is replaced") {
  std::string a, b, c;
  SupersedeField field;
  const auto running = field.ask(a);
  field.registry.take_over("k", field.start, running, Superseding::after_current);
  REQUIRE(eventually([&] { return running->has_begun(); }));
  const auto waiting = field.ask(b);
  field.registry.take_over("k", field.start + 1ms, waiting, Superseding::after_current);
  CHECK_FALSE(waiting->has_begun());
  const auto newest = field.ask(c);
  field.registry.take_over("k", field.start + 2ms, newest, Superseding::after_current);
  CHECK(a.empty());
  CHECK(b == "superseded");
  field.go = true;
  REQUIRE(eventually([&] { return c == "done"; }));
  CHECK(a == "done");
}

TEST_CASE("At once: all that are there are stopped, also those that were let run before") {
  std::string a, b;
  SupersedeField field;
  const auto running = field.ask(a), waiting = field.ask(b);
  REQUIRE(eventually([&] { return running->has_begun(); }));
  field.registry.take_over("k", field.start, running, Superseding::after_current);
  field.registry.take_over("k", field.start + 1ms, waiting, Superseding::after_current);
  CHECK(a.empty());
  field.registry.take_over("k", field.start + 2ms, nullptr);
  CHECK(a == "superseded");
  CHECK(b == "superseded");
}

TEST_CASE("Many keys are not remembered for ever") {
  std::string last;
  SupersedeField field;
  for (int i = 0; i < 5000; ++i) field.registry.take_over(std::to_string(i), field.start, nullptr);
  const auto interest = field.ask(last);
  field.registry.take_over("k", field.start, interest);
  field.registry.take_over("k", field.start + 1ms, nullptr);
  CHECK(last == "superseded");
}

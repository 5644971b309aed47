// What happens when memory runs out at any place of an evaluation, one after the other.

#include "tests/service/failing_memory.h"

#include <catch2/catch.hpp>

#include "jobs/flights.h"
#include "tests/support/eventually.h"
#include "tests/support/requests.h"

using namespace dini;
using namespace dini::support;
using dini::support::allocations_left;
using dini::support::live_allocations;

namespace {

/// A boosted ring, sampled curves with points, and a warped mesh with a check: every part of the engine in small.
std::vector<Json> graphs() {
  const Json ring = document(
      {{"ring", make("circle", {{"radius", 1}})},
       {"tau", make("point_pair", {{"position", {0, 0, 1.5}}})},
       {"k", make("range", {{"to", {{"parameter", "reach"}}}, {"count", 6}})},
       {"boosted", make("boost", {{"shape", from("ring")}, {"generator", from("tau")}, {"amount", from("k")}})},
       {"skin", make("surface", {{"shape", from("boosted")}, {"segments", 8}})},
       {"out", make("export", {{"model", from("skin")}})}});
  const Json curves = document({{"ring", make("circle", {{"radius", {{"parameter", "reach"}}}})},
                                {"dots", make("sample", {{"shape", from("ring")}, {"count", 5}})},
                                {"shifts", make("expression", {{"formula", "sin(x) + reach"}, {"x", 0.5}})},
                                {"moved", make("translate", {{"shape", from("dots")}, {"vector", {0, 0, 1}}})},
                                {"out", make("export", {{"model", Json::array({from("moved"), from("ring")})}})}});
  const Json warped = document({{"ball", make("sphere_mesh", {{"segments", 8}, {"rings", 5}})},
                                {"pair", make("point_pair", {{"position", {0, 0, 3}}})},
                                {"bent", make("warp", {{"shape", from("ball")},
                                                       {"generators", from("pair")},
                                                       {"strength", {{"parameter", "reach"}}},
                                                       {"softening", 1}})},
                                {"size", make("measure", {{"model", from("bent")}})},
                                {"limit", make("check", {{"value", from("size.area")}, {"maximum", 1e6}})},
                                {"out", make("export", {{"model", from("bent")}})}});
  std::vector<Json> all = {ring, curves, warped};
  all[1]["nodes"]["shifts"]["inputs"]["formula"] = "sin(x) + 1";
  for (Json& graph : all)
    graph["parameters"]["reach"] = {{"type", "number"}, {"default", 1}, {"min", 0}, {"max", 1000}};
  return all;
}

Asked request_for(const Json& graph, int round) {
  return {.graph = graph, .parameters = {{"reach", 0.5 + 0.001 * round}}, .preview = {}};
}

/// The file, or the code of the problem, with memory as it is; exceptions other than for want of memory fail the test.
std::string outcome(const Engine& engine, const Asked& request) {
  try {
    const Result<Answered> answer = answered(engine, request);
    return answer ? *answer->glb : answer.problems().front().code;
  } catch (const std::bad_alloc&) {
    return "out-of-memory";
  }
}

}  // namespace

TEST_CASE("Wherever memory runs out, the answer says so, nothing leaks, and the next answer is right") {
  const std::vector<Json> all = graphs();
  // The cache holds a few results of this size and no more, so that each round computes anew.
  Limits limits;
  limits.cache_bytes = 64 * 1024;
  const std::unique_ptr<Engine> engine = make_engine(limits), reference = make_engine(limits);
  for (std::size_t which = 0; which < all.size(); ++which) {
    CAPTURE(which);
    int round = 0;
    for (; round < 30; ++round) outcome(*engine, request_for(all[which], round));  // what is made once and kept
    const long before = live_allocations;
    std::size_t failures = 0;
    for (long place = 0;; ++place, ++round) {
      const Asked request = request_for(all[which], round);
      allocations_left = place;
      const std::string failed = outcome(*engine, request);
      const bool reached = allocations_left < 0;
      allocations_left = -1;
      CAPTURE(place);
      if (reached && failed == "out-of-memory") ++failures;
      const std::string expected = outcome(*reference, request);
      REQUIRE((failed == "out-of-memory" || failed == expected));
      REQUIRE(outcome(*engine, request) == expected);
      if (!reached) break;
    }
    CHECK(failures > 300);
    CHECK(live_allocations - before < 2000);  // what both caches hold of the last rounds
  }
}

TEST_CASE("Wherever memory runs out while computations are shared, everybody is told something, once") {
  using Answer = Result<std::shared_ptr<const int>>;
  jobs::Alarms alarms;
  for (long place = 0; place < 60; ++place) {
    jobs::ComputeQueue queue({.places = 1, .waiting = 8, .bytes = 100});
    jobs::Flights flights(queue, alarms);
    std::atomic<int> told = 0, refused = 0;
    CAPTURE(place);
    allocations_left = place;
    for (std::uint8_t asker = 0; asker < 3; ++asker) {
      try {
        const auto interest = flights.ask<int>(
            {.key = {static_cast<std::uint8_t>(asker / 2)}},
            [](const Job&) -> Answer { return std::make_shared<const int>(1); },
            [&](const Answer&, jobs::Flights::Begun) { ++told; });
        if (interest == nullptr) ++refused;
      } catch (const std::bad_alloc&) {
        ++refused;
      }
    }
    const bool all = dini::support::eventually([&] { return told + refused == 3; });
    allocations_left = -1;
    CHECK(all);
  }
}

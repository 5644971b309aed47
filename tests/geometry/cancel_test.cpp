#include "geometry/cancel.h"

#include <catch2/catch.hpp>

using namespace dini;

TEST_CASE("A flag within another one stops with it and for its reason, and alone without it") {
  const Cancel outer;
  const Cancel within(Cancel::Clock::time_point::max(), outer);
  CHECK_FALSE(within.stopped());
  const Cancel late(Cancel::Clock::now(), outer);
  CHECK(late.stopped());
  CHECK(late.reason() == StopReason::deadline);
  CHECK_FALSE(outer.stopped());
  outer.stop(StopReason::client_gone);
  CHECK(within.stopped());
  CHECK(within.reason() == StopReason::client_gone);
  CHECK(late.reason() == StopReason::deadline);
}

#include "server/computation.h"

#include <algorithm>

namespace dini::server {
namespace {

Cancel::Clock::time_point deadline_of(const Call& call, std::optional<std::int64_t> milliseconds) {
  const auto limit = static_cast<std::int64_t>(call.engine().limits().interactive_milliseconds);
  const std::int64_t wanted = milliseconds.value_or(limit);
  return call.exchange.started + std::chrono::milliseconds(std::min(wanted, limit));
}

}  // namespace

Computation::Computation(Call& call, std::optional<std::int64_t> milliseconds)
    : call_(call),
      cancel_(deadline_of(call, milliseconds)),
      running_(call.application.running, call.exchange.socket, cancel_),
      newest_(call.application.supersede, call.header("Supersede-Key"), cancel_) {}

Result<Gate::Pass> Computation::enter() {
  const double before = call_.exchange.milliseconds();
  auto pass = call_.application.gate.enter(cancel_);
  call_.exchange.timings.emplace_back("queue", call_.exchange.milliseconds() - before);
  return pass;
}

}  // namespace dini::server

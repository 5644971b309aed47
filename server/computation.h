#pragma once

#include <cstdint>
#include <optional>

#include "server/routes.h"

namespace dini::server {

/// A request that computes: its deadline, and everything that may stop it before.
class Computation {
 public:
  /// `milliseconds` is what the client allows; the deadline counts from the request's first byte and never passes the
  /// limit. The request with the same `Supersede-Key` before this one is stopped.
  Computation(Call& call, std::optional<std::int64_t> milliseconds);

  const Cancel& cancel() const { return cancel_; }

  /// A slot to compute in; the wait is added to the timings of the answer.
  Result<Gate::Pass> enter();

 private:
  Call& call_;
  Cancel cancel_;
  RunningRequests::Entry running_;
  Supersede::Entry newest_;
};

}  // namespace dini::server

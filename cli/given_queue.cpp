#include "cli/given_queue.h"

#include "cli/problems.h"
#include "cli/terminal.h"

namespace dini::cli {

Result<queue::Address> read_queue(const std::string& text) {
  auto address = queue::read_address(text);
  if (!address) return usage_problem("--queue: " + address.problems().front().detail);
  return address;
}

int fail_at_queue(const queue::Fault& fault) {
  const bool is_wrong = fault.kind == queue::Fault::Kind::denied || fault.kind == queue::Fault::Kind::refused;
  return fail({{.code = "queue-failed", .detail = fault.detail}}, is_wrong ? exit_usage : exit_try_again);
}

}  // namespace dini::cli

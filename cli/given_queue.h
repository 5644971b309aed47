#pragma once

#include <string>

#include "cli/exit_codes.h"
#include "queue/address.h"
#include "queue/connection.h"

namespace dini::cli {

/// How a command writes the address of a queue.
inline constexpr const char* queue_form = "redis://[[user]:password@]host[:port][/database]";

/// The address that was given with `--queue`; a problem that names the option.
Result<queue::Address> read_queue(const std::string& text);

/// Tells why Redis did not do what was asked. The exit code says whether it may work later.
int fail_at_queue(const queue::Fault& fault);

}  // namespace dini::cli

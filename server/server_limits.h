#pragma once

#include "server/settings.h"
#include "service/limit_table.h"

namespace dini::server {

/// The limits of connections, requests and answers. Those of graphs are `evaluation_limits`.
std::span<const Limit<Settings>> server_limits();

}  // namespace dini::server

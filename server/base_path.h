#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dini::server {

/// What an address is below the path that everything is served below: "/v1/nodes" for "/dini/v1/nodes", and nothing
/// for the base itself without its slash. Probes are answered beside the base too. Nothing for what is elsewhere.
std::optional<std::string_view> below_base(std::string_view path, std::string_view base);

/// Why text cannot be a base path; empty when it can: one or more segments of [A-Za-z0-9._~-], as "/tools/dini".
std::string fault_in_base_path(std::string_view text);

}  // namespace dini::server

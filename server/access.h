#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "graph/problem.h"
#include "server/request.h"
#include "server/settings.h"

namespace dini::server {

/// Whether this request may be answered at all, by its head alone. A web page anywhere can make a browser send requests
/// to 127.0.0.1, so: the Host must be one of ours (no rebinding of names), a foreign Origin may not post, pages of
/// other sites may not make browsers load what is below `needs_token` (`Sec-Fetch-Site`), unless their origin is let in
/// or somebody follows a link, and with a token set every request that `needs_token` must carry it. Probes may do
/// without all of that.
std::optional<Problem> check_access(const Request& request, const Settings& settings);

/// Whether it carries a token, be it the right one or not.
bool carries_token(const Request& request);

/// Whether it is an address that load balancers ask by number, without a name or a token.
bool is_probe(std::string_view path);

/// Whether a request for that path has to carry the token, where there is one.
bool needs_token(std::string_view path);

/// The origin of another site whose pages may read the answer, as `Access-Control-Allow-Origin` says it; empty for
/// none.
std::string shared_origin(const Request& request, const Settings& settings);

}  // namespace dini::server

#include "server/access.h"

#include <algorithm>

#include "server/addresses.h"
#include "server/text.h"

namespace dini::server {
namespace {

/// The token of `Authorization: Bearer <token>`, whatever the case of its scheme; empty when there is none.
std::string_view bearer_token(std::string_view authorization) {
  constexpr std::string_view scheme = "Bearer ";
  if (!equal_ignoring_case(authorization.substr(0, scheme.size()), scheme)) return {};
  return trim(authorization.substr(scheme.size()));
}

std::string_view usual_port(std::string_view scheme) { return scheme == "https" ? ":443" : ":80"; }

/// Whether a name with its port is one that --allow-host gave: with any port, or with this one.
bool is_allowed(std::string_view authority, std::string_view scheme, const Settings& settings) {
  const std::string_view name = without_port(authority);
  std::string full(authority);
  if (name == authority && !scheme.empty()) full += usual_port(scheme);
  return std::ranges::any_of(settings.allowed_hosts, [&](const std::string& allowed) {
    return equal_ignoring_case(allowed, full) || equal_ignoring_case(allowed, name);
  });
}

bool is_our_host(std::string_view host, std::string_view scheme, const Settings& settings) {
  const std::string_view name = without_port(host);
  return is_loopback(name) || equal_ignoring_case(name, settings.host) ||
         equal_ignoring_case(name, "[" + settings.host + "]") || is_allowed(host, scheme, settings);
}

/// A name without the port that its scheme has anyway.
std::string_view without_usual_port(std::string_view authority, std::string_view scheme) {
  const std::string_view port = usual_port(scheme);
  if (authority.ends_with(port)) authority.remove_suffix(port.size());
  return authority;
}

/// Whether a page of that origin is ours: it came from the host that it now asks, or from one of our names while a
/// proxy before us asks by another. Where a trusted proxy tells the scheme, that is part of it.
bool is_our_origin(std::string_view origin, const Request& request, const Settings& settings) {
  const std::string_view host = request.header("Host");
  for (const std::string_view scheme : {"http", "https"}) {
    const std::string beginning = std::string(scheme) + "://";
    if (!equal_ignoring_case(origin.substr(0, beginning.size()), beginning)) continue;
    if (!request.scheme.empty() && request.scheme != scheme) return false;
    const std::string_view authority = origin.substr(beginning.size());
    return is_allowed(authority, scheme, settings) ||
           equal_ignoring_case(without_usual_port(authority, scheme), without_usual_port(host, scheme));
  }
  return false;
}

/// In a time that does not tell how much of a guess was right.
bool equal_secrets(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned>(a[i] ^ b[i]);
  return difference == 0;
}

/// Whether a page of the origin that the request names may read answers and send requests.
bool is_let_in(const Request& request, const Settings& settings) {
  return is_our_origin(request.header("Origin"), request, settings) || !shared_origin(request, settings).empty();
}

/// Whether a browser says that a page of another site lets it load this, as an image or a script, which carries no
/// Origin. Following a link is not that: then a person looks at the answer, and no page does.
bool is_loaded_by_stranger(const Request& request, const Settings& settings) {
  return equal_ignoring_case(request.header("Sec-Fetch-Site"), "cross-site") &&
         !equal_ignoring_case(request.header("Sec-Fetch-Mode"), "navigate") && !is_let_in(request, settings);
}

}  // namespace

bool carries_token(const Request& request) { return !bearer_token(request.header("Authorization")).empty(); }

bool is_probe(std::string_view path) { return path == "/healthz" || path == "/readyz"; }

bool needs_token(std::string_view path) { return path.starts_with("/v1/") || path == "/metrics"; }

std::string shared_origin(const Request& request, const Settings& settings) {
  const std::string origin(request.header("Origin"));
  for (const std::string& allowed : settings.allowed_origins) {
    if (allowed == "*") return allowed;
    if (equal_ignoring_case(allowed, origin)) return origin;
  }
  return {};
}

std::optional<Problem> check_access(const Request& request, const Settings& settings) {
  if (is_probe(request.path)) return std::nullopt;
  const std::string_view host = request.header("Host");
  if (request.has_header("Host") && !is_our_host(host, request.scheme, settings)) {
    return Problem{.code = "misdirected-request",
                   .detail = "The host '" + escape_controls(host, 80) +
                             "' is not served here; start with --allow-host to add it."};
  }
  // What may be done is asked without the token, before anything is.
  if (request.method == "OPTIONS") return std::nullopt;
  const bool changes = request.method != "GET" && request.method != "HEAD";
  if (changes && request.has_header("Origin") && !is_let_in(request, settings)) {
    return Problem{.code = "foreign-origin",
                   .detail =
                       "Pages from other origins may not send requests here; start with --allow-origin to add "
                       "one, or with --allow-host to add the name of a proxy."};
  }
  if (needs_token(request.path) && is_loaded_by_stranger(request, settings)) {
    return Problem{.code = "foreign-origin",
                   .detail = "Pages of other sites may not load this; start with --allow-origin to add one."};
  }
  if (!settings.token.empty() && needs_token(request.path) &&
      !equal_secrets(bearer_token(request.header("Authorization")), settings.token)) {
    return Problem{.code = "unauthorized",
                   .detail = "Send 'Authorization: Bearer <token>' with the token of this server."};
  }
  return std::nullopt;
}

}  // namespace dini::server

#include "server/access.h"

#include <algorithm>
#include <array>

#include "server/text.h"

namespace dini::server {
namespace {

std::string_view without_port(std::string_view host) {
  const auto colon = host.rfind(':');
  const auto bracket = host.rfind(']');
  const bool has_port = colon != std::string_view::npos && (bracket == std::string_view::npos || colon > bracket);
  return has_port ? host.substr(0, colon) : host;
}

bool is_our_host(std::string_view host, const Settings& settings) {
  constexpr std::array<std::string_view, 3> local = {"localhost", "127.0.0.1", "[::1]"};
  const std::string_view name = without_port(host);
  const auto same = [&](std::string_view candidate) { return equal_ignoring_case(candidate, name); };
  return std::ranges::any_of(local, same) || same(settings.host) || same("[" + settings.host + "]") ||
         std::ranges::any_of(settings.allowed_hosts, same);
}

bool is_same_origin(std::string_view origin, std::string_view host) {
  return equal_ignoring_case(origin, "http://" + std::string(host)) ||
         equal_ignoring_case(origin, "https://" + std::string(host));
}

/// In a time that does not tell how much of a guess was right.
bool equal_secrets(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned>(a[i] ^ b[i]);
  return difference == 0;
}

}  // namespace

std::optional<Problem> check_access(const httplib::Request& request, const Settings& settings) {
  const std::string host = request.get_header_value("Host");
  if (!is_our_host(host, settings)) {
    return Problem{.code = "misdirected-request",
                   .detail = "The host '" + escape_controls(host, 80) +
                             "' is not served here; start with --allow-host to add it."};
  }
  const bool changes = request.method != "GET" && request.method != "HEAD";
  if (changes && request.has_header("Origin") && !is_same_origin(request.get_header_value("Origin"), host)) {
    return Problem{.code = "foreign-origin", .detail = "Pages from other origins may not send requests here."};
  }
  if (!settings.token.empty() && request.path.starts_with("/v1/")) {
    if (!equal_secrets(request.get_header_value("Authorization"), "Bearer " + settings.token)) {
      return Problem{.code = "unauthorized",
                     .detail = "Send 'Authorization: Bearer <token>' with the token of this server."};
    }
  }
  return std::nullopt;
}

}  // namespace dini::server

#include "server/addresses.h"

#include <arpa/inet.h>
#include <httplib.h>

#include "server/text.h"

namespace dini::server {

std::string decoded_path(std::string_view path) {
  if (path.find('%') == std::string_view::npos) return std::string(path);
  return httplib::detail::decode_url(std::string(path), false);
}

std::vector<std::pair<std::string, std::string>> decoded_query(std::string_view query) {
  std::vector<std::pair<std::string, std::string>> fields;
  for (const std::string_view field : split(query, '&')) {
    const auto equals = field.find('=');
    const auto decoded = [](std::string_view text) { return httplib::detail::decode_url(std::string(text), true); };
    fields.emplace_back(decoded(field.substr(0, equals)),
                        equals == std::string_view::npos ? "" : decoded(field.substr(equals + 1)));
  }
  return fields;
}

std::string_view without_port(std::string_view authority) {
  const auto colon = authority.rfind(':');
  const auto bracket = authority.rfind(']');
  const bool has_port = colon != std::string_view::npos && (bracket == std::string_view::npos || colon > bracket);
  return has_port ? authority.substr(0, colon) : authority;
}

bool is_loopback(std::string_view host) {
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  if (equal_ignoring_case(host, "localhost")) return true;
  const std::string text(host);
  in_addr v4{};
  if (::inet_pton(AF_INET, text.c_str(), &v4) == 1) return ntohl(v4.s_addr) >> 24 == 127;
  in6_addr v6{};
  return ::inet_pton(AF_INET6, text.c_str(), &v6) == 1 && IN6_IS_ADDR_LOOPBACK(&v6);
}

}  // namespace dini::server

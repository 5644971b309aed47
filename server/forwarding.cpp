#include "server/forwarding.h"

#include <algorithm>

#include "server/text.h"

namespace dini::server {
namespace {

bool is_trusted(const Address& address, const Settings& settings) {
  return std::ranges::any_of(settings.trusted_proxies,
                             [&](const Network& network) { return network.contains(address); });
}

/// The entries of all headers of that name, in their order.
std::vector<std::string_view> entries_of(const Request& request, std::string_view name) {
  std::vector<std::string_view> entries;
  for (const auto& [header, value] : request.headers) {
    if (!equal_ignoring_case(header, name)) continue;
    const auto more = split(value, ',');
    entries.insert(entries.end(), more.begin(), more.end());
  }
  return entries;
}

/// The address without the port that some proxies tell with it.
std::optional<Address> read_client(std::string_view entry) {
  if (entry.starts_with('[')) return Address::parse(entry.substr(1, std::min(entry.find(']'), entry.size()) - 1));
  if (std::ranges::count(entry, ':') == 1) entry = entry.substr(0, entry.find(':'));
  return Address::parse(entry);
}

bool is_authority(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view(".-_:[]").find(c) != std::string_view::npos;
  });
}

}  // namespace

void take_forwarding(const std::optional<Address>& peer, const Settings& settings, Request& request,
                     Exchange& exchange) {
  if (!peer) return;
  exchange.client = peer->text();
  if (!is_trusted(*peer, settings)) return;
  const auto clients = entries_of(request, "X-Forwarded-For");
  for (auto entry = clients.rbegin(); entry != clients.rend(); ++entry) {
    const auto client = read_client(*entry);
    if (!client) break;
    exchange.client = client->text();
    if (!is_trusted(*client, settings)) break;
  }
  if (const auto schemes = entries_of(request, "X-Forwarded-Proto"); !schemes.empty()) {
    const std::string scheme = to_lower(schemes.back());
    if (scheme == "http" || scheme == "https") request.scheme = scheme;
  }
  const auto hosts = entries_of(request, "X-Forwarded-Host");
  if (hosts.empty() || !is_authority(hosts.back())) return;
  std::string host(hosts.back());
  std::erase_if(request.headers, [](const auto& header) { return equal_ignoring_case(header.first, "Host"); });
  request.headers.emplace_back("Host", std::move(host));
}

}  // namespace dini::server

#include "nodes/links.h"

#include <charconv>

namespace dini {

namespace {

bool is_between(char letter) { return letter == ' ' || letter == ',' || letter == '\n' || letter == '\t'; }

}  // namespace

std::optional<Links> read_links(const std::string& text) {
  Links links;
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto number = [&](std::uint32_t& value) {
    const auto [rest, error] = std::from_chars(at, end, value);
    at = rest;
    return error == std::errc();
  };
  while (true) {
    while (at != end && is_between(*at)) ++at;
    if (at == end) return links;
    auto& [first, second] = links.emplace_back();
    if (!number(first) || at == end || *at++ != '-' || !number(second)) return std::nullopt;
    if (at != end && !is_between(*at)) return std::nullopt;
  }
}

std::optional<std::string> fault_of_links(const std::string& text) {
  if (read_links(text)) return std::nullopt;
  return "links are pairs of indices such as \"0-1 1-2\", counted from 0";
}

}  // namespace dini

#include "queue/address.h"

#include <charconv>
#include <optional>
#include <string_view>

namespace dini::queue {
namespace {

Problem wrong(const std::string& why) {
  return {.code = "usage",
          .detail = "the address of a queue is redis://[[user]:password@]host[:port][/database], and " + why};
}

std::optional<int> number(std::string_view text, int least, int most) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < least || value > most) return std::nullopt;
  return value;
}

int digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// With `%40` as `@`, so that a password may have any character.
std::string unescaped(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escaped = text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0;
    plain += escaped ? static_cast<char>(16 * digit(text[i + 1]) + digit(text[i + 2])) : text[i];
    if (escaped) i += 2;
  }
  return plain;
}

}  // namespace

Result<Address> read_address(const std::string& text) {
  constexpr std::string_view scheme = "redis://";
  std::string_view rest = text;
  if (!rest.starts_with(scheme)) return wrong("this one does not begin with redis://");
  rest.remove_prefix(scheme.size());
  Address address;
  if (const auto at = rest.rfind('@'); at != std::string_view::npos) {
    const std::string_view login = rest.substr(0, at);
    const auto colon = login.find(':');
    if (colon == std::string_view::npos) return wrong("what stands before its @ has no colon before the password");
    address.user = unescaped(login.substr(0, colon));
    address.password = unescaped(login.substr(colon + 1));
    if (address.password.empty()) return wrong("its password is empty");
    rest.remove_prefix(at + 1);
  }
  if (const auto slash = rest.find('/'); slash != std::string_view::npos) {
    const std::string_view path = rest.substr(slash + 1);
    const auto database = path.empty() ? 0 : number(path, 0, 1'000'000);
    if (!database) return wrong("what follows its last / is no number of a database");
    address.database = *database;
    rest = rest.substr(0, slash);
  }
  const auto bracket = rest.rfind(']');
  const auto colon = rest.rfind(':');
  if (colon != std::string_view::npos && (bracket == std::string_view::npos || colon > bracket)) {
    const auto port = number(rest.substr(colon + 1), 1, 65535);
    if (!port) return wrong("its port is no number from 1 to 65535");
    address.port = *port;
    rest = rest.substr(0, colon);
  }
  if (rest.starts_with('[') && rest.ends_with(']')) rest = rest.substr(1, rest.size() - 2);
  if (rest.empty()) return wrong("it names no host");
  address.host = rest;
  return address;
}

}  // namespace dini::queue

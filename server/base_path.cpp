#include "server/base_path.h"

#include <algorithm>

#include "server/access.h"

namespace dini::server {

std::optional<std::string_view> below_base(std::string_view path, std::string_view base) {
  if (base.empty() || is_probe(path)) return path;
  if (!path.starts_with(base)) return std::nullopt;
  path.remove_prefix(base.size());
  if (!path.empty() && !path.starts_with('/')) return std::nullopt;
  return path;
}

std::string fault_in_base_path(std::string_view text) {
  const std::string_view form = "it begins with a slash and does not end with one, as /tools/dini";
  if (text.empty()) return "";
  if (!text.starts_with('/') || text.ends_with('/')) return std::string(form);
  while (!text.empty()) {
    text.remove_prefix(1);
    const std::string_view segment = text.substr(0, text.find('/'));
    const bool plain = std::ranges::all_of(segment, [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
             std::string_view("._~-").find(c) != std::string_view::npos;
    });
    if (segment.empty() || segment == "." || segment == "..") return std::string(form);
    if (!plain) return "its segments have letters, digits, and . _ ~ - only";
    text.remove_prefix(segment.size());
  }
  return "";
}

}  // namespace dini::server

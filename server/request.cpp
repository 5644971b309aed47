#include "server/request.h"

#include <algorithm>

#include "server/text.h"

namespace dini::server {
namespace {

auto find(const Request::Fields& headers, std::string_view name) {
  return std::ranges::find_if(headers, [&](const auto& header) { return equal_ignoring_case(header.first, name); });
}

}  // namespace

std::string_view Request::header(std::string_view name) const {
  const auto found = find(headers, name);
  return found == headers.end() ? std::string_view{} : std::string_view(found->second);
}

bool Request::has_header(std::string_view name) const { return find(headers, name) != headers.end(); }

}  // namespace dini::server

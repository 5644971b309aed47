#include "server/trace.h"

#include <algorithm>
#include <string_view>

namespace dini::server {
namespace {

constexpr std::size_t most_id_bytes = 64;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_hexadecimal(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return is_digit(c) || (c >= 'a' && c <= 'f'); });
}

/// A number that is not zero, which would mean that there is none.
bool is_name(std::string_view text) {
  return is_hexadecimal(text) && text.find_first_not_of('0') != std::string_view::npos;
}

bool is_request_id(std::string_view text) {
  const auto is_plain = [](char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' || c == '_' || c == '-';
  };
  return !text.empty() && text.size() <= most_id_bytes && std::ranges::all_of(text, is_plain);
}

/// "00-<32 digits of the trace>-<16 of the span>-<2 of flags>", of a later version perhaps with more behind a dash.
void take_trace(std::string_view text, Exchange& exchange) {
  constexpr std::size_t size = 55;
  if (text.size() < size || text[2] != '-' || text[35] != '-' || text[52] != '-') return;
  const std::string_view version = text.substr(0, 2), trace = text.substr(3, 32), span = text.substr(36, 16);
  if (!is_hexadecimal(version) || version == "ff" || !is_name(trace) || !is_name(span)) return;
  if (!is_hexadecimal(text.substr(53, 2))) return;
  if (text.size() > size && (version == "00" || text[size] != '-')) return;
  exchange.trace = trace;
  exchange.span = span;
}

}  // namespace

void take_names(const Request& request, Exchange& exchange) {
  if (const std::string_view id = request.header("X-Request-Id"); is_request_id(id)) exchange.id = id;
  take_trace(request.header("traceparent"), exchange);
}

}  // namespace dini::server

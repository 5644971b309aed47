#include "server/request_head.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "server/addresses.h"
#include "server/base_path.h"
#include "server/text.h"

namespace dini::server {
namespace {

constexpr std::string_view line_end = "\r\n";

Problem bad_request(std::string detail) { return {.code = "bad-request", .detail = std::move(detail)}; }

bool is_token_character(char c) {
  const bool alphanumeric = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  return alphanumeric || std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
}

bool is_token(std::string_view text) { return !text.empty() && std::ranges::all_of(text, is_token_character); }

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

bool is_method(std::string_view method) {
  constexpr std::array<std::string_view, 7> methods = {"GET", "HEAD", "POST", "PUT", "PATCH", "DELETE", "OPTIONS"};
  return std::ranges::find(methods, method) != methods.end();
}

bool may_have_body(std::string_view method) {
  return method == "POST" || method == "PUT" || method == "PATCH" || method == "DELETE";
}

/// What a percent sign at the start stands for; nothing when no two hexadecimal digits follow.
std::optional<char> percent_decoded(std::string_view text) {
  unsigned value = 0;
  if (text.size() < 3) return std::nullopt;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 3, value, 16);
  if (error != std::errc() || end != text.data() + 3) return std::nullopt;
  return static_cast<char>(value);
}

/// Controls hidden behind percent signs: whoever decodes an address must not meet a line end or a NUL.
bool hides_control(std::string_view text) {
  for (auto sign = text.find('%'); sign != std::string_view::npos; sign = text.find('%', sign + 1)) {
    const auto decoded = percent_decoded(text.substr(sign));
    if (decoded && is_control(*decoded)) return true;
  }
  return false;
}

/// Nothing here decodes headers. But a whole line end or a NUL behind percent signs is there only to forge a line in
/// whatever decodes it later; unless it is in what a browser sends along of other programs and pages.
bool hides_line_end(std::string_view name, std::string_view value) {
  if (equal_ignoring_case(name, "Cookie") || equal_ignoring_case(name, "Referer")) return false;
  const std::string lower = to_lower(value);
  return lower.find("%0d%0a") != std::string::npos || lower.find("%00") != std::string::npos;
}

bool is_target(std::string_view target) {
  const auto is_forbidden = [](char c) {
    return is_control(c) || c == ' ' || c == '#' || static_cast<unsigned char>(c) > 0x7e;
  };
  if (std::ranges::any_of(target, is_forbidden) || hides_control(target)) return false;
  for (auto sign = target.find('%'); sign != std::string_view::npos; sign = target.find('%', sign + 1)) {
    if (!percent_decoded(target.substr(sign))) return false;
  }
  return true;
}

std::optional<Problem> read_request_line(std::string_view line, const Settings& settings, RequestHead& head) {
  if (line.size() + line_end.size() > settings.line_bytes) {
    return Problem{.code = "uri-too-long",
                   .detail = "The request line is longer than " + std::to_string(settings.line_bytes) + " bytes."};
  }
  const auto first = line.find(' ');
  const auto last = line.rfind(' ');
  if (first == std::string_view::npos || first == last) {
    return bad_request("The request line must be a method, a target and a version.");
  }
  head.request.method = line.substr(0, first);
  head.target = line.substr(first + 1, last - first - 1);
  const std::string_view version = line.substr(last + 1);
  if (!is_token(head.request.method)) return bad_request("The method is not a token.");
  if (version != "HTTP/1.1" && version != "HTTP/1.0") {
    if (version.starts_with("HTTP/")) {
      return Problem{.code = "http-version", .detail = "Only HTTP/1.1 and HTTP/1.0 are spoken here."};
    }
    return bad_request("The request line must end with the HTTP version.");
  }
  head.is_old = version == "HTTP/1.0";
  if (!is_method(head.request.method)) {
    return Problem{.code = "method-not-allowed", .detail = "This method is not known here."};
  }
  return std::nullopt;
}

/// Takes the target apart. One with a scheme and a host, as for a proxy, means its own host and not that of the header
/// (RFC 9112, 3.2.2).
std::optional<Problem> read_target(const Settings& settings, RequestHead& head) {
  std::string_view target = head.target;
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (!equal_ignoring_case(target.substr(0, scheme.size()), scheme)) continue;
    target.remove_prefix(scheme.size());
    const std::string_view host = target.substr(0, target.find_first_of("/?"));
    if (host.empty() || host.find('@') != std::string_view::npos) return bad_request("The target names no host.");
    target.remove_prefix(host.size());
    const auto hosts = std::erase_if(head.request.headers,
                                     [](const auto& header) { return equal_ignoring_case(header.first, "Host"); });
    if (hosts > 1) return bad_request("Exactly one Host header is needed.");
    head.request.headers.emplace_back("Host", host);
    break;
  }
  const bool of_server = target == "*" && head.request.method == "OPTIONS";
  if (target.empty() || target.starts_with('?')) {
    head.request.path = "/";
  } else if (!target.starts_with('/') && !of_server) {
    return bad_request("The target must be a path.");
  }
  if (!is_target(target)) {
    return bad_request("The target holds a control character, a space, '#' or a byte that should be percent-encoded.");
  }
  const auto question = target.find('?');
  if (head.request.path.empty()) head.request.path = decoded_path(target.substr(0, question));
  if (const auto below = below_base(head.request.path, settings.base_path); below && !of_server) {
    head.request.path = std::string(*below);
  } else if (!of_server) {
    return Problem{.code = "not-found", .detail = "Everything is below " + settings.base_path + "/ here."};
  }
  if (question != std::string_view::npos) head.request.query = target.substr(question + 1);
  return std::nullopt;
}

/// Takes "name: value" apart; no spaces before the colon, no folded lines, no controls.
std::optional<Problem> read_header_line(std::string_view line, const Settings& settings, RequestHead& head) {
  if (line.size() > settings.line_bytes || head.request.headers.size() >= settings.header_count) {
    return Problem{.code = "headers-too-large",
                   .detail = "At most " + std::to_string(settings.header_count) + " headers of " +
                             std::to_string(settings.line_bytes) + " bytes each are accepted."};
  }
  const auto colon = line.find(':');
  if (colon == std::string_view::npos || !is_token(line.substr(0, colon))) {
    return bad_request("A header is not of the form 'Name: value'.");
  }
  const std::string_view value = trim(line.substr(colon + 1));
  if (std::ranges::any_of(value, [](char c) { return is_control(c) && c != '\t'; }) ||
      hides_line_end(line.substr(0, colon), value)) {
    return bad_request("A header value holds a control character.");
  }
  head.request.headers.emplace_back(line.substr(0, colon), value);
  return std::nullopt;
}

std::optional<Problem> read_length(std::string_view value, RequestHead& head) {
  std::size_t length = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), length);
  const bool digits = !value.empty() && std::ranges::all_of(value, [](char c) { return c >= '0' && c <= '9'; });
  if (!digits) return bad_request("Content-Length must be a decimal number.");
  // A length past 64 bits is a lie rather than a large body.
  if (error != std::errc() || end != value.data() + value.size()) return bad_request("Content-Length is out of range.");
  head.content_length = length;
  return std::nullopt;
}

/// Takes out the headers that decide where the request ends, so that nobody after us decides differently.
std::optional<Problem> read_framing(RequestHead& head) {
  std::optional<std::string> length;
  std::size_t hosts = 0;
  Request::Fields kept;
  for (auto& [name, value] : head.request.headers) {
    const std::string lower = to_lower(name);
    if (lower == "transfer-encoding") {
      if (head.is_chunked || head.is_old || !equal_ignoring_case(value, "chunked")) {
        return bad_request("The only Transfer-Encoding is 'chunked', once, in HTTP/1.1.");
      }
      head.is_chunked = true;
      continue;
    }
    if (lower == "content-encoding" && to_lower(value) != "identity") {
      return Problem{.code = "unsupported-media-type", .detail = "Compressed request bodies are not accepted."};
    }
    if (lower == "content-length") {
      if (length) return bad_request("Content-Length is given twice.");
      length = value;
    } else if (lower == "expect") {
      if (to_lower(value) != "100-continue") {
        return Problem{.code = "expectation-failed", .detail = "Only 'Expect: 100-continue' is understood."};
      }
      head.expects_continue = !head.is_old;
    } else if (lower == "connection") {
      const std::string options = to_lower(value);
      head.close = head.close || std::ranges::count(split(options, ','), std::string_view("close")) > 0;
    } else if (lower != "content-encoding") {
      hosts += lower == "host" ? 1 : 0;
      kept.emplace_back(std::move(name), std::move(value));
    }
  }
  head.request.headers = std::move(kept);
  head.close = head.close || head.is_old;
  // Before HTTP/1.1 there was no such header. No browser speaks that, so no page can be behind it.
  if (hosts > 1 || (hosts == 0 && !head.is_old)) return bad_request("Exactly one Host header is needed.");
  const std::string& method = head.request.method;
  // One of the two would be for another reader: the way to smuggle a request past a proxy.
  if (length && head.is_chunked) return bad_request("Content-Length and Transfer-Encoding exclude each other.");
  if (head.is_chunked && !may_have_body(method)) return bad_request("A " + method + " request must not have a body.");
  if (length) {
    if (auto problem = read_length(*length, head)) return problem;
    if (head.content_length > 0 && !may_have_body(method)) {
      return bad_request("A " + method + " request must not have a body.");
    }
  } else {
    head.lacks_length = may_have_body(method) && method != "DELETE" && !head.is_chunked;
  }
  return std::nullopt;
}

}  // namespace

Result<RequestHead> parse_head(std::string_view bytes, const Settings& settings) {
  RequestHead head;
  bool first = true;
  while (true) {
    const auto end = bytes.find(line_end);
    if (end == std::string_view::npos) return bad_request("The head does not end with an empty line.");
    const std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(end + line_end.size());
    if (line.empty() && !first) break;
    auto problem = first ? read_request_line(line, settings, head) : read_header_line(line, settings, head);
    if (problem) return *std::move(problem);
    first = false;
  }
  if (auto problem = read_target(settings, head)) return *std::move(problem);
  if (auto problem = read_framing(head)) return *std::move(problem);
  return head;
}

std::optional<Problem> check_unfinished_head(std::string_view bytes, const Settings& settings) {
  const auto end = bytes.find(line_end);
  const bool in_first_line = end == std::string_view::npos;
  const std::string_view first_line = bytes.substr(0, end);
  if (first_line.size() > settings.line_bytes) {
    return Problem{.code = "uri-too-long",
                   .detail = "The request line is longer than " + std::to_string(settings.line_bytes) + " bytes."};
  }
  // Other protocols (a TLS hello, say) show themselves in the first line; waiting for its end could take for ever.
  const std::string_view text = in_first_line && bytes.ends_with('\r') ? bytes.substr(0, bytes.size() - 1) : first_line;
  if (std::ranges::any_of(text, is_control)) return bad_request("This is not HTTP.");
  const auto last = bytes.rfind(line_end);
  const bool long_line = !in_first_line && bytes.size() - last - line_end.size() > settings.line_bytes;
  if (bytes.size() >= settings.head_bytes || long_line) {
    return Problem{.code = "headers-too-large",
                   .detail = "The headers are larger than " + std::to_string(settings.head_bytes) +
                             " bytes, or one of them than " + std::to_string(settings.line_bytes) + "."};
  }
  return std::nullopt;
}

}  // namespace dini::server

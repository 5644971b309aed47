#include "server/incoming_body.h"

#include <algorithm>
#include <charconv>

namespace dini::server {
namespace {

/// Of a line between chunks, and of all lines after the last one.
constexpr std::size_t line_limit = 256;
constexpr std::size_t trailer_limit = 4096;
/// More than these could not be told from a number that has wrapped around.
constexpr std::size_t most_digits = 8;

Problem bad_chunk(std::string detail) { return {.code = "bad-request", .detail = std::move(detail)}; }

bool is_control(char c) { return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f; }

}  // namespace

IncomingBody IncomingBody::of_length(std::size_t bytes) {
  return {bytes > 0 ? State::data : State::complete, bytes, bytes};
}

IncomingBody IncomingBody::in_chunks(std::size_t limit) {
  IncomingBody body(State::size_line, 0, limit);
  body.chunked_ = true;
  return body;
}

Result<std::size_t> IncomingBody::take(std::string_view bytes) {
  std::size_t taken = 0;
  while (taken < bytes.size() && !is_complete()) {
    const std::string_view rest = bytes.substr(taken);
    if (state_ == State::data) {
      taken += take_data(rest);
      continue;
    }
    const auto line = take_line(rest);
    if (!line) return line.problems();
    taken += *line;
  }
  return taken;
}

std::size_t IncomingBody::take_data(std::string_view bytes) {
  const std::string_view own = bytes.substr(0, missing_);
  bytes_.append(own);
  missing_ -= own.size();
  if (missing_ == 0) state_ = chunked_ ? State::data_end : State::complete;
  return own.size();
}

/// Takes what comes until the end of a line.
Result<std::size_t> IncomingBody::take_line(std::string_view bytes) {
  const auto end = bytes.find('\n');
  const std::string_view own = bytes.substr(0, end == std::string_view::npos ? end : end + 1);
  if (line_.size() + own.size() > line_limit) return bad_chunk("A line between chunks is too long.");
  line_.append(own);
  if (end == std::string_view::npos) return own.size();
  if (auto problem = end_line()) return *std::move(problem);
  line_.clear();
  return own.size();
}

/// Does what a complete line says.
std::optional<Problem> IncomingBody::end_line() {
  if (!line_.ends_with("\r\n")) return bad_chunk("A line between chunks does not end with CR and LF.");
  line_.resize(line_.size() - 2);
  if (std::ranges::any_of(line_, is_control)) return bad_chunk("A line between chunks holds a control character.");
  switch (state_) {
    case State::size_line:
      return begin_chunk();
    case State::data_end:
      if (!line_.empty()) return bad_chunk("A chunk is longer than it says.");
      state_ = State::size_line;
      return std::nullopt;
    case State::trailer:
      trailer_ += line_.size() + 2;
      if (trailer_ > trailer_limit) return bad_chunk("There are too many lines after the last chunk.");
      if (line_.empty()) state_ = State::complete;
      return std::nullopt;
    case State::data:
    case State::complete:
      break;
  }
  return std::nullopt;
}

std::optional<Problem> IncomingBody::begin_chunk() {
  const std::string_view digits = std::string_view(line_).substr(0, line_.find(';'));
  std::size_t size = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), size, 16);
  const bool is_number = !digits.empty() && digits.front() != '-' && digits.size() <= most_digits;
  if (!is_number || error != std::errc() || end != digits.data() + digits.size()) {
    return bad_chunk("The size of a chunk is 1 to 8 hexadecimal digits.");
  }
  if (size > limit_ - bytes_.size()) {
    return Problem{.code = "body-too-large",
                   .detail = "The body has more than " + std::to_string(limit_) + " bytes, which are accepted."};
  }
  missing_ = size;
  state_ = size > 0 ? State::data : State::trailer;
  return std::nullopt;
}

}  // namespace dini::server

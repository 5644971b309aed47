#include "geometry/text_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dini {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Whether a number that no double can hold is too small rather than too large: by the place of its first digit that is
/// not 0, counted from the point, and its exponent.
bool is_too_small(std::string_view number) {
  const std::size_t end = std::min(number.find_first_of("eE"), number.size());
  const std::string_view digits = number.substr(0, end);
  const std::string_view power = number.substr(std::min(end + 1, number.size()));
  const auto point = static_cast<std::int64_t>(std::min(digits.find('.'), digits.size()));
  const auto first = static_cast<std::int64_t>(digits.find_first_of("123456789"));
  const auto exponent = integer_from<std::int32_t>(power);
  if (!exponent && !power.empty()) return power.front() == '-';
  return point - first + exponent.value_or(0) < 0;
}

/// What older Microsoft libraries print for numbers that are not finite, with any digits behind: 1.#INF, -1.#IND00.
std::optional<double> microsoft_number(std::string_view word) {
  const bool negative = word.starts_with('-');
  if (negative) word.remove_prefix(1);
  if (!word.starts_with("1.#")) return std::nullopt;
  word.remove_prefix(3);
  if (word.starts_with("INF")) return negative ? -infinity : infinity;
  const bool undefined = word.starts_with("QNAN") || word.starts_with("SNAN") || word.starts_with("IND");
  return undefined ? std::optional(std::numeric_limits<double>::quiet_NaN()) : std::nullopt;
}

}  // namespace

std::optional<double> real_from(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error == std::errc::invalid_argument) return microsoft_number(word);
  if (error != std::errc::result_out_of_range) return value;
  const bool negative = word.starts_with('-');
  if (is_too_small(word.substr(negative ? 1 : 0))) return negative ? -0.0 : 0.0;
  return negative ? -infinity : infinity;
}

std::optional<std::int64_t> whole_from(std::string_view word) {
  if (const auto integer = integer_from<std::int64_t>(word)) return integer;
  constexpr double most = 9007199254740992;  // 2^53
  const auto real = real_from(word);
  if (!real || !(std::abs(*real) < most) || *real != std::trunc(*real)) return std::nullopt;
  return static_cast<std::int64_t>(*real);
}

std::string text_of(double number) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof(text), number).ptr};
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t most = 32;
  std::string text(word.substr(0, most));
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return '"' + text + (word.size() > most ? "...\"" : "\"");
}

}  // namespace dini

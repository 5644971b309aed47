#pragma once

// Lines, words and numbers of a text from outside, without copies.

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace dini {

/// What parts words; lines end with some of it.
inline constexpr std::string_view white_space = " \t\r\n\v\f";

/// The text behind the byte order mark of UTF-8, where there is one.
inline std::string_view without_byte_order_mark(std::string_view text) {
  return text.substr(text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
}

/// Takes a text apart line by line; lines end with LF, CR or both.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}

  /// The next line without its end, or nothing after the last.
  std::optional<std::string_view> next() {
    if (rest_.empty()) return std::nullopt;
    const std::size_t end = rest_.find_first_of("\r\n");
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + (rest_.substr(end, 2) == "\r\n" ? 2 : 1));
    ++number_;
    return line;
  }

  std::size_t number() const { return number_; }  ///< of the last line, from 1
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// The next word of `line`, taken off its front; empty at its end. Words are parted by any white space.
inline std::string_view take_word(std::string_view& line) {
  const std::size_t begin = line.find_first_not_of(white_space);
  if (begin == std::string_view::npos) {
    line = {};
    return {};
  }
  line.remove_prefix(begin);
  const std::string_view word = line.substr(0, line.find_first_of(white_space));
  line.remove_prefix(word.size());
  return word;
}

/// A whole number that is the whole word, written as an integer; nothing when it is not, or does not fit.
template <class Integer>
std::optional<Integer> integer_from(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  Integer value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// A number that is the whole word, as printing it in C, C++, Python or Java gives it: infinite and undefined ones
/// too (`inf`, `-nan(ind)`, `1.#QNAN`), zero where it is too small for a double (`1e-400`) and infinity where it is too
/// large. Nothing for what is no number.
std::optional<double> real_from(std::string_view word);

/// A whole number below 2^53, also when it is written with a fraction of zeros (`255.0`).
std::optional<std::int64_t> whole_from(std::string_view word);

/// A number for a message, with as few digits as tell it.
std::string text_of(double number);

/// The word in quotes for a message: its first 32 bytes, with a question mark for what is not printable ASCII.
std::string in_quotes(std::string_view word);

}  // namespace dini

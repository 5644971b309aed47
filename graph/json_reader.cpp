#include "graph/json_reader.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace dini {

namespace {

/// A number of JSON is a double, however it is spelled (RFC 8785): 16, 16.0 and 1.6e1 become the same value, kept as an
/// integer where every neighbor is one too; and there is one zero.
Json number(double value) {
  constexpr double largest_exact_integer = 9007199254740992;  // 2^53
  if (value != std::floor(value) || std::abs(value) > largest_exact_integer) return value;
  return static_cast<std::int64_t>(value);
}

/// "line 3, column 7" of a byte. Columns count characters, not bytes.
std::string place_text(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line_start = before.rfind('\n') + 1;  // 0 in the first line
  const auto is_first_byte = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  const std::string_view line = before.substr(line_start);
  return "line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n')) + ", column " +
         std::to_string(1 + std::count_if(line.begin(), line.end(), is_first_byte));
}

/// Builds the document while counting; stops at the first thing that is refused.
class StrictReader : public nlohmann::json_sax<Json> {
 public:
  StrictReader(std::string_view text, const Limits& limits) : text_(text), limits_(limits) {}

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(number(static_cast<double>(value))); }
  bool number_unsigned(number_unsigned_t value) override { return add(number(static_cast<double>(value))); }
  bool number_float(number_float_t value, const string_t&) override { return add(number(value)); }
  bool string(string_t& value) override {
    if (value.find('\0') != string_t::npos) return refuse("not-json", "a text holds the character NUL");
    return short_enough(value) && add(std::move(value));
  }
  bool binary(binary_t&) override { return refuse("not-json", "binary values are not JSON"); }

  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    if (!short_enough(name)) return false;
    if (std::any_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; })) {
      return refuse("not-json", "a name holds a control character");
    }
    if (stack_.back()->contains(name))
      return refuse("not-json", "the name " + Json(name).dump() + " stands twice in one object");
    key_ = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) override {
    // Numbers beyond double arrive here too; the library's text repeats the whole token, so it is not passed on.
    const bool overflow = error.id == 406;
    error_at_ = position == 0 ? 0 : position - 1;
    problem_ = {"not-json", (overflow ? "a number is too large, at " : "the text is not JSON, at ") +
                                place_text(text_, *error_at_)};
    return false;
  }

  /// Where the syntax is wrong, if that is what is wrong.
  std::optional<std::size_t> error_at() const { return error_at_; }

  Result<Json> result(bool read) && {
    if (read) return std::move(root_);
    return problem_;
  }

 private:
  bool refuse(std::string code, std::string detail) {
    problem_ = {std::move(code), std::move(detail)};
    return false;
  }

  bool short_enough(const std::string& text) {
    if (text.size() <= limits_.string_bytes) return true;
    return refuse("limit-exceeded", "a text is longer than " + std::to_string(limits_.string_bytes) + " bytes");
  }

  bool count() {
    if (++values_ <= limits_.json_values) return true;
    return refuse("limit-exceeded", "the document holds more than " + std::to_string(limits_.json_values) + " values");
  }

  Json* place(Json value) {
    if (stack_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Json& parent = *stack_.back();
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return &parent.back();
    }
    return &(parent[key_] = std::move(value));
  }

  bool add(Json value) {
    if (!count()) return false;
    place(std::move(value));
    return true;
  }

  bool open(Json value) {
    if (!count()) return false;
    if (stack_.size() >= limits_.json_depth) {
      return refuse("not-json", "the document is nested deeper than " + std::to_string(limits_.json_depth) + " levels");
    }
    stack_.push_back(place(std::move(value)));
    return true;
  }

  bool close() {
    stack_.pop_back();
    return true;
  }

  const std::string_view text_;
  const Limits& limits_;
  Json root_;
  std::vector<Json*> stack_;
  std::string key_;
  std::size_t values_ = 0;
  std::optional<std::size_t> error_at_;
  Problem problem_;
};

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // some editors put one before their UTF-8

/// Reads characters and remembers how far it came, for the reader below does not tell.
struct WatchedCharacters {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at = nullptr;
  const char** farthest = nullptr;

  reference operator*() const { return *at; }
  WatchedCharacters& operator++() {
    *farthest = ++at;
    return *this;
  }
  bool operator==(const WatchedCharacters& other) const { return at == other.at; }
};

/// Where the token begins whose last byte is before `end`: a name or a text, or a bracket.
std::size_t token_begin(std::string_view text, std::size_t end) {
  if (end == 0 || text[end - 1] != '"') return end == 0 ? 0 : end - 1;
  std::size_t begin = end - 1;
  const auto is_escaped = [&](std::size_t quote) {
    std::size_t slashes = 0;
    while (slashes < quote && text[quote - slashes - 1] == '\\') ++slashes;
    return slashes % 2 == 1;
  };
  do {
    begin = begin == 0 ? std::string_view::npos : text.rfind('"', begin - 1);
  } while (begin != std::string_view::npos && is_escaped(begin));
  return begin == std::string_view::npos ? 0 : begin;
}

}  // namespace

std::optional<std::size_t> offset_of_fault(std::string_view text, const Limits& limits) {
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) return nul;
  const std::size_t skipped = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  text.remove_prefix(skipped);
  if (text.starts_with(byte_order_mark)) return skipped;
  StrictReader reader(text, limits);
  const char* farthest = text.data();
  const WatchedCharacters begin{text.data(), &farthest}, end{text.data() + text.size(), &farthest};
  if (Json::sax_parse(begin, end, &reader)) return std::nullopt;
  if (const auto error = reader.error_at()) return skipped + std::min(*error, text.size());
  return skipped + token_begin(text, static_cast<std::size_t>(farthest - text.data()));
}

Result<Json> parse_json(std::string_view text, const Limits& limits) {
  if (text.find('\0') != std::string_view::npos) return Problem{"not-json", "the text holds a NUL byte"};
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  // The library passes over a further one by itself.
  if (text.starts_with(byte_order_mark)) return Problem{"not-json", "the text starts with two byte order marks"};
  StrictReader reader(text, limits);
  const bool read = Json::sax_parse(text, &reader);
  const bool is_syntax = reader.error_at().has_value();
  Result<Json> result = std::move(reader).result(read);
  if (read || is_syntax || result.problems().front().code != "not-json") return result;
  // Syntax is told with its place by then, and what else is refused is read once more for it.
  Problem problem = result.problems().front();
  if (const auto offset = offset_of_fault(text, limits)) problem.detail += ", at " + place_text(text, *offset);
  return problem;
}

std::string pointer_token(std::string_view token) {
  std::string escaped;
  for (const char c : token) {
    if (c == '~') {
      escaped += "~0";
    } else if (c == '/') {
      escaped += "~1";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

}  // namespace dini

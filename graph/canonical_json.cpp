#include "graph/canonical_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace dini {

namespace {

/// As ECMAScript does it (Number::toString): the shortest digits that read back, without an exponent from 1e-6 up to
/// but not including 1e21.
void write_number(std::string& out, double value) {
  if (value == 0) {
    out += '0';  // there is one zero
    return;
  }
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::abs(value), std::chars_format::scientific);
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data()));
  const std::size_t mark = text.find('e');
  std::string digits(1, text.front());
  if (mark > 2) digits += text.substr(2, mark - 2);
  int exponent = 0;
  const bool small = text[mark + 1] == '-';
  std::from_chars(text.data() + mark + 2, text.data() + text.size(), exponent);
  if (small) exponent = -exponent;
  if (value < 0) out += '-';
  const int count = static_cast<int>(digits.size());
  constexpr int most_places = 21, least_exponent = -7;
  if (exponent >= count - 1 && exponent < most_places) {
    out += digits + std::string(static_cast<std::size_t>(exponent - count + 1), '0');
  } else if (exponent >= 0 && exponent < most_places) {
    out += digits.insert(static_cast<std::size_t>(exponent + 1), ".");
  } else if (exponent < 0 && exponent >= least_exponent + 1) {
    out += "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
  } else {
    if (count > 1) digits.insert(1, ".");
    out += digits + (small ? "e-" : "e+") + std::to_string(std::abs(exponent));
  }
}

/// For the order of UTF-16 code units, what the code point that begins at `at` counts as: surrogates, which stand for
/// everything beyond the first 65,536, come before the last 8,192 of those.
std::uint32_t rank_at(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t offset) {
    return at + offset < text.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(text[at + offset])) : 0U;
  };
  const std::uint32_t first = byte(0);
  const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  std::uint32_t point = length == 1 ? first : first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) point = point << 6 | (byte(i) & 0x3FU);
  at += length;
  constexpr std::uint32_t after_surrogates = 0xE000, beyond = 0x10000, moved = 0x200000;
  return point >= after_surrogates && point < beyond ? point + moved : point;
}

bool stands_before(std::string_view a, std::string_view b) {
  std::size_t at_a = 0, at_b = 0;
  while (at_a < a.size() && at_b < b.size()) {
    const std::uint32_t rank_a = rank_at(a, at_a), rank_b = rank_at(b, at_b);
    if (rank_a != rank_b) return rank_a < rank_b;
  }
  return at_a >= a.size() && at_b < b.size();
}

/// Most texts are names and stand as they are.
bool needs_escape(char c) { return c < ' ' || c > '~' || c == '"' || c == '\\'; }

void write_text(std::string& out, const std::string& text) {
  if (std::ranges::any_of(text, needs_escape)) {
    out += Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
    return;
  }
  out += '"';
  out += text;
  out += '"';
}

/// Whether the order of bytes, which members have, may not be that of UTF-16 code units: from the bytes that begin
/// U+E000.
bool may_be_reordered(const std::string& name) {
  return std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) >= 0xEE; });
}

void write(std::string& out, const Json& json, std::span<const std::string_view> left_out);

void write_object(std::string& out, const Json& json, std::span<const std::string_view> left_out) {
  std::vector<std::pair<const std::string*, const Json*>> members;
  bool is_ordered = true;
  for (const auto& [name, value] : json.get_ref<const Json::object_t&>()) {
    if (std::ranges::find(left_out, name) == left_out.end()) members.emplace_back(&name, &value);
    is_ordered = is_ordered && !may_be_reordered(name);
  }
  if (!is_ordered) {
    std::ranges::sort(members, [](const auto& a, const auto& b) { return stands_before(*a.first, *b.first); });
  }
  out += '{';
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (i > 0) out += ',';
    write_text(out, *members[i].first);
    out += ':';
    write(out, *members[i].second, {});
  }
  out += '}';
}

/// Recursion is as deep as the document, which its reader bounds.
void write(std::string& out, const Json& json, std::span<const std::string_view> left_out) {
  if (json.is_object()) return write_object(out, json, left_out);
  if (json.is_number()) return write_number(out, json.get<double>());
  if (json.is_string()) return write_text(out, json.get_ref<const std::string&>());
  if (!json.is_array()) {
    out += json.is_null() ? "null" : json.get<bool>() ? "true" : "false";
    return;
  }
  out += '[';
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (i > 0) out += ',';
    write(out, json[i], {});
  }
  out += ']';
}

}  // namespace

std::string canonical_json(const Json& json, std::span<const std::string_view> left_out) {
  std::string out;
  write(out, json, left_out);
  return out;
}

}  // namespace dini

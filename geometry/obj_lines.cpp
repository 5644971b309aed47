#include "geometry/obj_lines.h"

#include <algorithm>
#include <array>

namespace dini {

namespace {

/// A '#' begins a comment, also right behind a number, unless it is part of one: 1.#QNAN, 1.#INF.
std::size_t comment_begin(std::string_view line) {
  std::size_t at = line.find('#');
  while (at != std::string_view::npos && at > 0 && line[at - 1] == '.' && at + 1 < line.size() &&
         std::string_view("IQS").find(line[at + 1]) != std::string_view::npos) {
    at = line.find('#', at + 1);
  }
  return at;
}

/// Whether a statement is made of numbers; those of the others are names, or begin with nothing that is known.
bool has_numbers(std::string_view statement) {
  constexpr std::array<std::string_view, 19> keywords = {"v",    "vt",   "vn",   "vp",   "f",   "fo",  "l",
                                                         "p",    "curv", "surf", "parm", "sp",  "con", "curv2",
                                                         "trim", "hole", "scrv", "bmat", "step"};
  return std::ranges::find(keywords, take_word(statement)) != keywords.end();
}

/// A line without its comment, and whether the next line goes on with it.
struct LinePiece {
  std::string_view text;
  bool goes_on = false;
};

LinePiece piece_of(std::string_view line) {
  const std::size_t comment = comment_begin(line);
  if (comment != std::string_view::npos) return {line.substr(0, comment)};
  const std::size_t last = line.find_last_not_of(white_space);
  if (last == std::string_view::npos || line[last] != '\\') return {line};
  return {line.substr(0, last), true};
}

}  // namespace

std::optional<std::string_view> ObjLines::next() {
  const auto line = lines_.next();
  if (!line) return std::nullopt;
  number_ = lines_.number();
  // Files that were put together out of others have such marks in their middle.
  const std::string_view begin = without_byte_order_mark(*line);
  LinePiece piece = piece_of(begin);
  if (!piece.goes_on) return piece.text;
  if (!has_numbers(begin)) return begin;
  joined_ = piece.text;
  while (piece.goes_on && !steps_.stopped()) {
    const auto more = lines_.next();
    if (!more) break;
    piece = piece_of(*more);
    (joined_ += ' ') += piece.text;
  }
  return joined_;
}

}  // namespace dini

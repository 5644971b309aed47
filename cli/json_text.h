#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace dini::cli {

struct TextMember;

/// A value in JSON text, with the bytes where it stands: [begin, end).
struct TextValue {
  enum class Kind { scalar, array, object };

  Kind kind = Kind::scalar;
  std::size_t begin = 0;
  std::size_t end = 0;
  std::vector<TextMember> members = {};  ///< of an array or an object, in the order in which they are written
};

/// An element of an array, or a member of an object; `begin` is where it begins, with its name.
struct TextMember {
  std::string name = {};
  std::size_t begin = 0;
  TextValue value = {};
};

/// Where something stands: lines and columns count from 1, columns count characters.
struct TextPlace {
  std::size_t line = 1;
  std::size_t column = 1;
};

/// The tree of a text that is well-formed JSON of bounded depth, with or without a byte order mark.
TextValue read_json_text(std::string_view text);

/// Where the member that a JSON pointer leads to begins; the innermost one around it when the text has none there.
std::size_t offset_of(const TextValue& root, std::string_view pointer);

TextPlace place_at(std::string_view text, std::size_t offset);

}  // namespace dini::cli

#include "geometry/ply_header.h"

#include <array>
#include <utility>

#include "geometry/text_reader.h"

namespace dini {

namespace {

constexpr std::size_t most_elements = 16;
constexpr std::size_t most_properties = 64;
constexpr std::size_t most_header_bytes = 64 * 1024;

std::optional<PlyType> type_from(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, PlyType>, 16> words = {{{"char", PlyType::int8},
                                                                           {"int8", PlyType::int8},
                                                                           {"uchar", PlyType::uint8},
                                                                           {"uint8", PlyType::uint8},
                                                                           {"short", PlyType::int16},
                                                                           {"int16", PlyType::int16},
                                                                           {"ushort", PlyType::uint16},
                                                                           {"uint16", PlyType::uint16},
                                                                           {"int", PlyType::int32},
                                                                           {"int32", PlyType::int32},
                                                                           {"uint", PlyType::uint32},
                                                                           {"uint32", PlyType::uint32},
                                                                           {"float", PlyType::float32},
                                                                           {"float32", PlyType::float32},
                                                                           {"double", PlyType::float64},
                                                                           {"float64", PlyType::float64}}};
  for (const auto& [name, type] : words) {
    if (name == word) return type;
  }
  return std::nullopt;
}

/// The fewest bytes that one item of an element takes.
std::size_t least_size(const PlyElement& element, PlyEncoding encoding) {
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties) {
    size += encoding == PlyEncoding::ascii ? 1 : size_of(property.length.value_or(property.type));
  }
  return size;
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return small;
}

class HeaderReader {
 public:
  explicit HeaderReader(std::string_view bytes)
      : bytes_(bytes), lines_(without_byte_order_mark(bytes.substr(0, most_header_bytes))) {}

  Expected<PlyHeader, ImportError> read() {
    if (!begins_like_ply(bytes_)) return invalid_file("the first line must be \"ply\"");
    bool has_format = false;
    while (const auto next = lines_.next()) {
      const std::string words = in_small_letters(*next);
      std::string_view line = words;
      const std::string_view keyword = take_word(line);
      bool good = true;
      if (keyword == "end_header") {
        if (!has_format) return fail("there is no format");
        header_.size = data_begin();
        header_.lines = lines_.number();
        return check_counts();
      }
      if (keyword == "format") {
        has_format = good = read_format(line);
      } else if (keyword == "element") {
        good = read_element(line);
      } else if (keyword == "property") {
        good = read_property(line);
      } else {
        good = keyword.empty() || keyword == "comment" || keyword == "obj_info" || lines_.number() == 1;
      }
      if (!good) return fail(in_quotes(words) + " cannot be understood");
    }
    return fail("the header does not end");
  }

 private:
  ImportError fail(const std::string& what) const {
    return invalid_file("line " + std::to_string(lines_.number()) + " of the header: " + what);
  }

  /// Where the data begin. Behind lines that end with CR alone a LF is their first byte, and no end of a line.
  std::size_t data_begin() const {
    const std::size_t begin = std::min(bytes_.size(), most_header_bytes) - lines_.rest().size();
    const std::size_t first_end = bytes_.find_first_of("\r\n");
    const bool ends_with_cr = bytes_[first_end] == '\r' && bytes_.substr(first_end + 1, 1) != "\n";
    return begin - (ends_with_cr && bytes_[begin - 1] == '\n' ? 1 : 0);
  }

  bool read_format(std::string_view line) {
    const std::string_view encoding = take_word(line);
    if (encoding == "binary_little_endian") header_.encoding = PlyEncoding::little_endian;
    if (encoding == "binary_big_endian") header_.encoding = PlyEncoding::big_endian;
    return (encoding == "ascii" || header_.encoding != PlyEncoding::ascii) && take_word(line) == "1.0";
  }

  bool read_element(std::string_view line) {
    const std::string_view name = take_word(line);
    const auto count = integer_from<std::uint64_t>(take_word(line));
    if (name.empty() || !count || header_.elements.size() == most_elements) return false;
    header_.elements.push_back({std::string(name), static_cast<std::size_t>(*count), {}});
    return true;
  }

  bool read_property(std::string_view line) {
    if (header_.elements.empty() || header_.elements.back().properties.size() == most_properties) return false;
    PlyProperty property;
    std::string_view word = take_word(line);
    if (word == "list") {
      property.length = type_from(take_word(line));
      if (!property.length || !is_integer(*property.length)) return false;
      word = take_word(line);
    }
    const auto type = type_from(word);
    property.name = take_word(line);
    if (!type || property.name.empty()) return false;
    property.type = *type;
    header_.elements.back().properties.push_back(std::move(property));
    return true;
  }

  Expected<PlyHeader, ImportError> check_counts() {
    const std::size_t rest = bytes_.size() - header_.size;
    for (const PlyElement& element : header_.elements) {
      const std::size_t least = least_size(element, header_.encoding);
      if (element.count > 0 && (least == 0 || element.count > rest / least)) {
        return invalid_file("the header promises " + std::to_string(element.count) + " of " + in_quotes(element.name) +
                            ", which the file is too short for");
      }
    }
    return std::move(header_);
  }

  std::string_view bytes_;
  LineReader lines_;
  PlyHeader header_;
};

}  // namespace

bool begins_like_ply(std::string_view bytes) {
  std::string_view line = LineReader(without_byte_order_mark(bytes)).next().value_or("");
  return in_small_letters(take_word(line).substr(0, 4)) == "ply" && take_word(line).empty();
}

Expected<PlyHeader, ImportError> read_ply_header(std::string_view bytes) { return HeaderReader(bytes).read(); }

}  // namespace dini

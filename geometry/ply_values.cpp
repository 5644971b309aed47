#include "geometry/ply_values.h"

#include <algorithm>
#include <bit>

#include "geometry/text_reader.h"

namespace dini {

namespace {

double value_of(std::uint64_t bits, PlyType type) {
  switch (type) {
    case PlyType::int8:
      return static_cast<std::int8_t>(bits);
    case PlyType::int16:
      return static_cast<std::int16_t>(bits);
    case PlyType::int32:
      return static_cast<std::int32_t>(bits);
    case PlyType::float32:
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case PlyType::float64:
      return std::bit_cast<double>(bits);
    default:
      return static_cast<double>(bits);
  }
}

/// How many lines of any kind of end stand before the end of a text.
std::size_t line_ends(std::string_view text) {
  LineReader lines(text);
  while (lines.next()) continue;
  return lines.number();
}

}  // namespace

PlyValues::PlyValues(std::string_view bytes, const PlyHeader& header)
    : whole_(bytes.substr(header.size)), data_(whole_), header_(header) {}

std::optional<double> PlyValues::next(PlyType type) {
  if (header_.encoding == PlyEncoding::ascii) return real_from(take_word(data_));
  const std::size_t size = size_of(type);
  if (data_.size() < size) return std::nullopt;
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = header_.encoding == PlyEncoding::little_endian ? size - 1 - i : i;
    bits = bits << 8 | static_cast<unsigned char>(data_[at]);
  }
  data_.remove_prefix(size);
  return value_of(bits, type);
}

bool PlyValues::skip(PlyType type) {
  if (header_.encoding == PlyEncoding::ascii) return !take_word(data_).empty();
  if (data_.size() < size_of(type)) return false;
  data_.remove_prefix(size_of(type));
  return true;
}

bool PlyValues::begins_line() {
  if (header_.encoding != PlyEncoding::ascii) return true;
  const std::size_t begin = std::min(data_.find_first_not_of(white_space), data_.size());
  const bool ended = data_.substr(0, begin).find_first_of("\r\n") != std::string_view::npos;
  const bool first = data_.size() == whole_.size();
  data_.remove_prefix(begin);
  return ended || first;
}

bool PlyValues::at_end() {
  if (header_.encoding == PlyEncoding::ascii) begins_line();
  return data_.empty();
}

std::string PlyValues::place() const {
  const std::size_t passed = whole_.size() - data_.size();
  if (header_.encoding != PlyEncoding::ascii) return "byte " + std::to_string(header_.size + passed);
  return "line " + std::to_string(header_.lines + std::max<std::size_t>(line_ends(whole_.substr(0, passed)), 1));
}

}  // namespace dini

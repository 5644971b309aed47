#include "geometry/file_format.h"

#include <algorithm>

namespace dini {

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) { return lower(x) == lower(y); });
}

template <class Predicate>
const FileFormat* first_format(std::span<const FileFormat> formats, Predicate fits) {
  const auto found = std::ranges::find_if(formats, fits);
  return found == formats.end() ? nullptr : &*found;
}

}  // namespace

const FileFormat* format_named(std::span<const FileFormat> formats, std::string_view name) {
  return first_format(formats, [&](const FileFormat& format) { return format.name == name; });
}

const FileFormat* format_of_type(std::span<const FileFormat> formats, std::string_view media_type) {
  return first_format(formats, [&](const FileFormat& format) {
    return std::ranges::any_of(format.media_types, [&](const auto& known) { return same_word(known, media_type); });
  });
}

const FileFormat* format_of_extension(std::span<const FileFormat> formats, std::string_view extension) {
  return first_format(formats, [&](const FileFormat& format) { return same_word(format.extension, extension); });
}

}  // namespace dini

#include "geometry/ply_items.h"

#include <cmath>
#include <utility>

#include "geometry/counted.h"
#include "geometry/text_reader.h"

namespace dini {

void PlyItems::fail(std::string what) {
  if (error_) return;
  if (!uneven_.empty()) what += "; " + uneven_ + " has not the values that the header names";
  error_ = invalid_file(values_.place() + ": " + what);
}

void PlyItems::fail(ImportError error) {
  if (!error_) error_ = std::move(error);
}

bool PlyItems::stopped() {
  if (!error_ && steps_.stopped()) error_ = stopped_reading();
  return error_.has_value();
}

void PlyItems::begin() {
  if (!values_.begins_line() && uneven_.empty()) uneven_ = values_.place();
}

double PlyItems::value(const PlyProperty& property) {
  if (stopped()) return 0;
  const auto number = values_.next(property.type);
  if (!number) fail("the data end, or " + in_quotes(property.name) + " is no number");
  return number.value_or(0);
}

std::size_t PlyItems::length(const PlyProperty& list) {
  const double length = value({list.name, *list.length, {}});
  const std::size_t each = header_.encoding == PlyEncoding::ascii ? 1 : size_of(list.type);
  const std::size_t most = values_.rest() / each;
  if (error_) return 0;
  if (length >= 0 && length <= static_cast<double>(most) && length == std::trunc(length))
    return static_cast<std::size_t>(length);
  fail("the length of " + in_quotes(list.name) + " is none, or more than the rest of the file can hold");
  return 0;
}

void PlyItems::skip(const PlyProperty& property) {
  const std::size_t count = property.length ? length(property) : 1;
  for (std::size_t i = 0; i < count && !stopped(); ++i) {
    if (!values_.skip(property.type)) fail("the data end within " + in_quotes(property.name));
  }
}

std::optional<std::string> PlyItems::rest() {
  if (values_.at_end()) return std::nullopt;
  if (!uneven_.empty()) fail("there is more than the header names");
  return counted(values_.rest(), "byte behind the last element is", "bytes behind the last element are") + " left out";
}

}  // namespace dini

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "geometry/cancel.h"
#include "geometry/text_reader.h"

namespace dini {

/// Takes an OBJ apart into statements: lines without their comments. A statement of numbers goes on in the next line
/// where it ends with a backslash, white space behind it or not. One that ends a comment or a name (`usemtl C:\art\`)
/// is part of it and joins nothing.
class ObjLines {
 public:
  /// Stops joining lines once `steps` is stopped.
  ObjLines(std::string_view text, CancelEvery& steps) : lines_(text), steps_(steps) {}

  /// The next statement, which may be empty; nothing after the last. It is valid until the next call.
  std::optional<std::string_view> next();

  std::size_t number() const { return number_; }  ///< of the line where the last statement begins, from 1

 private:
  LineReader lines_;
  CancelEvery& steps_;
  std::size_t number_ = 0;
  std::string joined_;
};

}  // namespace dini

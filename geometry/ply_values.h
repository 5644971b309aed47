#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/ply_header.h"

namespace dini {

/// The values behind the header of a PLY, one after the other, as doubles, which hold every type exactly. In ascii the
/// type does not count: `255.0` in a column of whole numbers is 255.
class PlyValues {
 public:
  /// `bytes` is the whole file, `header` what was read of it.
  PlyValues(std::string_view bytes, const PlyHeader& header);

  /// Nothing at the end of the file, and for a word that is no number.
  std::optional<double> next(PlyType type);

  /// Passes over a value that is not needed, a number or not; false at the end of the file.
  bool skip(PlyType type);

  /// Passes over white space before the next word; whether that begins a line. Always true in binary files.
  bool begins_line();

  /// What is left: in ascii as if no white space followed.
  std::size_t rest() const { return data_.size(); }
  bool at_end();

  /// Where the value that was read last ends, such as "line 17" or "byte 2048": counted anew with each call.
  std::string place() const;

 private:
  std::string_view whole_, data_;
  const PlyHeader& header_;
};

}  // namespace dini

#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "geometry/ply_columns.h"
#include "geometry/ply_values.h"

namespace dini {

/// Reads the items of the elements of a PLY one after the other. The first error stops everything that follows: values
/// are 0 from then on.
class PlyItems {
 public:
  PlyItems(std::string_view bytes, const PlyHeader& header, const Cancel& cancel)
      : header_(header), values_(bytes, header), steps_(cancel) {}

  const std::optional<ImportError>& error() const { return error_; }
  /// Where the value that was read last ends, such as "line 17"; it takes time to find.
  std::string place() const { return values_.place(); }
  /// Refuses the file at the place that was read last.
  void fail(std::string what);
  void fail(ImportError error);

  /// To be called before each item. One that does not begin a line tells of a row before it that does not fit the
  /// header; since some programs write many items into a line, that is a fault only if something else is wrong.
  void begin();

  double value(const PlyProperty& property);
  /// The length of a list, of which the file has to hold as many values as it says.
  std::size_t length(const PlyProperty& list);
  /// Passes over a value or a list without looking at what it holds.
  void skip(const PlyProperty& property);

  /// What stands behind the last element: refused when rows did not fit the header, else said in a sentence.
  std::optional<std::string> rest();

 private:
  bool stopped();

  const PlyHeader& header_;
  PlyValues values_;
  CancelEvery steps_;
  std::string uneven_;  ///< where the first item that does not begin a line does begin
  std::optional<ImportError> error_;
};

}  // namespace dini

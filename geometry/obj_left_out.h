#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace dini {

/// Counts what of an OBJ is not read.
class ObjLeftOut {
 public:
  /// A statement that is none of vertices or faces, in a line.
  void add(std::string_view keyword, std::size_t line);

  /// A weight of a vertex other than 1 or other numbers behind its position, and a third texture coordinate other than
  /// 0.
  void add_weight() { ++weights_; }
  void add_depth() { ++depths_; }

  /// Adds a sentence to the warnings for each kind that was met.
  void warn(std::vector<std::string>& warnings) const;

 private:
  std::size_t points_ = 0, lines_ = 0, free_forms_ = 0, materials_ = 0, weights_ = 0, depths_ = 0, unknown_ = 0;
  std::size_t first_unknown_ = 0;  ///< its line
};

}  // namespace dini

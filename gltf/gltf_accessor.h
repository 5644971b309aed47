#pragma once

// Numbers out of the binary chunk of a GLB.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace dini {

/// Values of `width` numbers each, all of them inside the binary chunk.
struct GltfRows {
  std::string_view bytes;
  std::size_t stride = 0;
  std::size_t type = 0;  ///< glTF's code of a component
};

/// The bytes of a component; 0 for a code that is none.
std::size_t component_size(std::size_t type);

/// The numbers of a type such as VEC3; 0 for one that is unknown.
std::size_t width_of(std::string_view type);

/// An accessor whose members have been checked: all that it says lies inside the file, so that reading cannot fail.
/// Where it has no rows of its own its values are 0; some are replaced by sparse ones.
class GltfAccessor {
 public:
  GltfAccessor(std::size_t count, std::size_t width, std::size_t type, bool normalized)
      : count_(count), width_(width), type_(type), normalized_(normalized) {}

  void set_rows(const GltfRows& rows) { rows_ = rows; }
  /// `places` ascend and are below the count.
  void set_sparse(std::size_t count, const GltfRows& places, const GltfRows& values);

  std::size_t count() const { return count_; }
  std::size_t width() const { return width_; }
  std::size_t type() const { return type_; }
  bool is_real() const;
  bool is_index() const;  ///< one unsigned whole number

  /// Whether any values stand in the file, and whether this one does: all others are 0.
  bool is_stored() const { return rows_.has_value(); }
  bool is_stored(std::size_t index) const { return rows_ || sparse_place(index); }

  /// Component `k` of value `index`. Integers that stand for shares of 1 become those; with `as_share` they all do.
  double number(std::size_t index, std::size_t k, bool as_share = false) const;
  /// Of an accessor that `is_index`.
  std::uint32_t whole(std::size_t index) const { return static_cast<std::uint32_t>(number(index, 0)); }

 private:
  std::optional<std::size_t> sparse_place(std::size_t index) const;

  std::size_t count_, width_, type_;
  bool normalized_;
  std::optional<GltfRows> rows_;
  std::size_t sparse_count_ = 0;
  GltfRows sparse_places_, sparse_values_;
};

}  // namespace dini

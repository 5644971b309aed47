#include "gltf/gltf_accessor.h"

#include <algorithm>
#include <array>
#include <bit>

namespace dini {

namespace {

enum ComponentType : std::size_t {
  signed_byte = 5120,
  unsigned_byte = 5121,
  signed_short = 5122,
  unsigned_short = 5123,
  unsigned_int = 5125,
  real = 5126,
};

double component_at(const GltfRows& rows, std::size_t index, std::size_t k, bool is_share) {
  const std::size_t size = component_size(rows.type);
  const char* bytes = rows.bytes.data() + index * rows.stride + k * size;
  std::uint32_t bits = 0;
  for (std::size_t i = size; i-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes[i]);
  switch (rows.type) {
    case signed_byte:
      return is_share ? std::max(static_cast<std::int8_t>(bits) / 127.0, -1.0) : static_cast<std::int8_t>(bits);
    case unsigned_byte:
      return is_share ? bits / 255.0 : bits;
    case signed_short:
      return is_share ? std::max(static_cast<std::int16_t>(bits) / 32767.0, -1.0) : static_cast<std::int16_t>(bits);
    case unsigned_short:
      return is_share ? bits / 65535.0 : bits;
    case real:
      return static_cast<double>(std::bit_cast<float>(bits));
    default:
      return bits;
  }
}

}  // namespace

std::size_t component_size(std::size_t type) {
  switch (type) {
    case signed_byte:
    case unsigned_byte:
      return 1;
    case signed_short:
    case unsigned_short:
      return 2;
    case unsigned_int:
    case real:
      return 4;
    default:
      return 0;
  }
}

std::size_t width_of(std::string_view type) {
  constexpr std::array<std::string_view, 4> vectors = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  if (type == "MAT4") return 16;
  const auto found = std::ranges::find(vectors, type);
  return found == vectors.end() ? 0 : static_cast<std::size_t>(found - vectors.begin()) + 1;
}

void GltfAccessor::set_sparse(std::size_t count, const GltfRows& places, const GltfRows& values) {
  sparse_count_ = count;
  sparse_places_ = places;
  sparse_values_ = values;
}

bool GltfAccessor::is_real() const { return type_ == real; }

bool GltfAccessor::is_index() const {
  return width_ == 1 && (type_ == unsigned_byte || type_ == unsigned_short || type_ == unsigned_int);
}

double GltfAccessor::number(std::size_t index, std::size_t k, bool as_share) const {
  const bool is_share = normalized_ || as_share;
  if (const auto place = sparse_place(index)) return component_at(sparse_values_, *place, k, is_share);
  return rows_ ? component_at(*rows_, index, k, is_share) : 0;
}

std::optional<std::size_t> GltfAccessor::sparse_place(std::size_t index) const {
  std::size_t begin = 0, end = sparse_count_;
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    const auto place = static_cast<std::size_t>(component_at(sparse_places_, middle, 0, false));
    if (place == index) return middle;
    place < index ? begin = middle + 1 : end = middle;
  }
  return std::nullopt;
}

}  // namespace dini

#include "geometry/scalar_field.h"

#include <algorithm>

namespace dini {

FieldSize size_over(const std::vector<SharedField>& branches, std::size_t own_bytes) {
  FieldSize size{1, 1, own_bytes};
  for (const SharedField& branch : branches) {
    size.operations += branch->size().operations;
    size.depth = std::max(size.depth, 1 + branch->size().depth);
    size.bytes += branch->size().bytes;
  }
  return size;
}

std::optional<std::string> too_large(const FieldSize& size) {
  if (size.operations > ScalarField::most_operations) {
    return "the field would have " + std::to_string(size.operations) + " operations, at most " +
           std::to_string(ScalarField::most_operations) + " are accepted";
  }
  if (size.depth > ScalarField::most_depth) {
    return "the field would be nested " + std::to_string(size.depth) + " deep, at most " +
           std::to_string(ScalarField::most_depth) + " is accepted";
  }
  return std::nullopt;
}

double value_at(const ScalarField& field, const Vector& place) {
  double value = 0;
  field.values({&place.x, &place.y, &place.z, 1}, &value);
  return value;
}

}  // namespace dini

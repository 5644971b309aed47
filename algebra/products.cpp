#include "algebra/products.h"

#include "algebra/construct.h"

namespace dini {

std::optional<Generator> unit_dual(const CircleCoordinates& circle, const Vector& origin) {
  if (circle.line) return line_from(to_point(to_vector(circle.point) - origin), circle.direction).dual;
  if (circle.radius == 0) return std::nullopt;
  const Point center = to_point(to_vector(circle.center) - origin);
  return (1 / circle.radius) * circle_from(center, circle.normal, circle.radius).dual;
}

}  // namespace dini

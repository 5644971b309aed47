#include "geometry/axis.h"

#include <limits>

namespace dini {

std::size_t sample_count(const Axes& axes) {
  std::size_t count = 1;
  for (const Axis& axis : axes) {
    if (axis.size == 0) return 0;
    if (count > std::numeric_limits<std::size_t>::max() / axis.size) return std::numeric_limits<std::size_t>::max();
    count *= axis.size;
  }
  return count;
}

}  // namespace dini

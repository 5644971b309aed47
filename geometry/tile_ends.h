#pragma once

#include <cstddef>
#include <vector>

namespace dini {

/// Ends a tile of a mesh behind so many triangles; one of which nothing is left is none.
inline void end_tile(std::vector<std::size_t>& ends, std::size_t triangles) {
  if (triangles > (ends.empty() ? 0 : ends.back())) ends.push_back(triangles);
}

}  // namespace dini

#pragma once

#include <string>
#include <variant>
#include <vector>

#include "geometry/mesh.h"

namespace dini {

/// One thing to draw under a name: a mesh, a set of polylines, or loose points.
struct Part {
  std::string name;
  std::variant<SharedMesh, std::vector<Polyline>, Column<Point>> shape;
  Color color = {0.75, 0.78, 0.82, 1};  ///< For polylines and points; a mesh carries its own.
};

/// What an export holds, in drawing order. All parts share one quantization grid when encoded.
struct Scene {
  std::vector<Part> parts;
};

}  // namespace dini

#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/family.h"
#include "geometry/mesh.h"

namespace dini {

/// Many curves that are made one by one when they are written, so that they never exist all at once.
struct CurveSource {
  std::size_t count = 0;
  std::function<Polyline(std::size_t)> curve;
};

/// One thing to draw under a name: a mesh, a set of polylines, or loose points.
struct Part {
  std::string name;
  std::variant<SharedMesh, std::vector<Polyline>, CurveSource, SharedColumn<Point>> shape;
  Color color = {0.75, 0.78, 0.82, 1};  ///< For polylines and points; a mesh carries its own.
  std::string material = {};            ///< Name of its material; parts share one by name and color.
};

/// What an export holds, in drawing order. All parts share one quantization grid when encoded.
struct Scene {
  std::vector<Part> parts;
};

}  // namespace dini

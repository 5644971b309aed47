#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gltf/glb_groups.h"
#include "graph/limits.h"
#include "graph/value.h"
#include "service/preview_frame.h"

namespace dini {

/// A value to draw.
struct PreviewedOutput {
  std::string name;
  Value value;
  std::optional<std::size_t> curve_axis = {};  ///< of points: the axis along which they make curves
};

/// What is drawn of a value: meshes as they are; points as points, or as lines along their curve; circles, lines and
/// spheres as lines; vectors from the origin; generators as control geometry, one child for each kind among them.
/// Numbers and files are not drawn. Of many elements an even choice is: the extras say how many there are and how many
/// are drawn. `points` bounds the points of all lines. Stopped early: not all of it.
std::vector<GlbChild> drawn_parts(const PreviewedOutput& output, const PreviewFrame& frame, const Limits& limits,
                                  std::size_t points, const Cancel& cancel);

}  // namespace dini

#pragma once

#include <optional>

#include "geometry/scene.h"
#include "graph/arguments.h"

namespace dini {

/// Values as the parts of a file. A part has the name of the node that made it, a mesh of a family also its place on
/// each axis ("skin[3,0]"), and what is given once more a number ("skin.2"); its material has the name of the node.
/// Circles and lines are curves that are made when they are written, points are shared. Stopped early: only some parts.
Scene scene_of(const Items& models, const Cancel& cancel);

/// In how many segments each circle of some values is drawn: as smoothly as usual, or coarser where there are so many
/// that the file would get out of hand.
std::size_t segments_of_circles(std::size_t circles);
inline constexpr std::size_t usual_circle_segments = 256;

/// The circles and lines among some values.
std::size_t count_circles(const Items& models);

/// What of a value no file can hold: points and circles at infinity, or farther than any coordinate may be. Stopped
/// early: fewer.
std::size_t count_out_of_reach(const Value& value, const Cancel& cancel);

}  // namespace dini

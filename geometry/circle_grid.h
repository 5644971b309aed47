#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algebra/extract.h"
#include "geometry/cancel.h"
#include "geometry/column.h"

namespace dini {

/// Points on a row of circles so that neighboring circles are sampled from neighboring starts: `segments` points each,
/// circle by circle, on closed columns.
///
/// The start of a circle is the start of the one before it, carried over without turning about the normal; when a
/// family passes through a line and comes back from the other side, the start stays on the near side. Around a closed
/// family the turn that is left is spread evenly. Circles wider than `widest` and lines are sampled denser near their
/// start, as a circle of that radius would be, so that what is in view keeps its detail; a line then holds the point at
/// infinity when `segments` is even. A missing circle gives points at infinity. Stopped early: points that mean
/// nothing.
Column<Point> sample_circle_row(const std::vector<std::optional<CircleCoordinates>>& circles, std::size_t segments,
                                bool closed_family, double widest, const Cancel& cancel);

}  // namespace dini

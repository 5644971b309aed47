#pragma once

#include "algebra/elements.h"
#include "geometry/cancel.h"
#include "geometry/column.h"
#include "geometry/scalar_field.h"

namespace dini {

/// The distance from a sphere, below zero inside.
SharedField sphere_field(const Vector& center, double radius);

/// The distance from a plane with unit normal at `distance` from the origin along it, below zero behind it.
SharedField plane_field(const Vector& normal, double distance);

/// The distance from the torus of tube radius `thickness` around a circle with unit normal, below zero in the tube.
/// `radius` may be zero: a sphere.
SharedField ring_field(const Vector& center, const Vector& normal, double radius, double thickness);

/// The distance from the cylinder of radius `thickness` around a line with unit direction, below zero inside.
SharedField rod_field(const Vector& point, const Vector& direction, double thickness);

/// The union of balls of one radius, their distances joined by `rounded_minimum` with `blend` (geometry/field_blend.h).
/// There must be one at least, and all must be finite. Stopped early: of no use.
SharedField balls_field(Column<Point> centers, double radius, double blend, const Cancel& cancel);

/// The distance from a box along the axes, measured by the largest coordinate, below zero inside.
SharedField box_field(const Vector& low, const Vector& high);

}  // namespace dini

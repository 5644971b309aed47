#pragma once

// How far elements are from each other, at which angles they meet, and where they are nearest to a point.

#include <optional>

#include "algebra/elements.h"

namespace dini {

// Elements that are none (see algebra/extract.h) give nothing throughout.

/// The point of a circle, line, sphere or plane nearest to a point. Of a point on the axis of a circle, or at infinity,
/// all are as near: the one where `point_at` starts; for the center of a sphere the one above it. Lines and planes hold
/// the point at infinity.
std::optional<Point> nearest_point(const Circle& circle, const Point& to);
std::optional<Point> nearest_point(const Sphere& sphere, const Point& to);

// The least distance of two elements in meters, spheres being surfaces; 0 where they meet. The point at infinity is at
// no distance: nothing, but for lines and planes, which hold it. Two circles, or a circle and a line, are searched: the
// result is right to about 1e-8 of their size.
std::optional<double> least_distance(const Point& a, const Point& b);
std::optional<double> least_distance(const Circle& a, const Point& b);
std::optional<double> least_distance(const Sphere& a, const Point& b);
std::optional<double> least_distance(const Circle& a, const Circle& b);
std::optional<double> least_distance(const Circle& a, const Sphere& b);
std::optional<double> least_distance(const Sphere& a, const Sphere& b);

// The cosine of the angle at which two elements meet; where they do not meet it is beyond 1. Of spheres and planes
// between the normals, those of spheres outward; of circles and lines between the directions in which they run; of a
// circle and a sphere between the circle and the sphere's tangent plane, 0 to 1. The same under every conformal map.
// Nothing for elements of radius zero.
std::optional<double> angle_cosine(const Circle& a, const Circle& b);
std::optional<double> angle_cosine(const Circle& a, const Sphere& b);
std::optional<double> angle_cosine(const Sphere& a, const Sphere& b);

}  // namespace dini

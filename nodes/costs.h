#pragma once

// What nodes need beyond the usual for their sizes. Measured on one processor of a small cloud machine, and rounded up:
// work in nanoseconds, memory in bytes.

#include "graph/node_type.h"

namespace dini {

/// A surface through a grid of points: samples, cuts, welds and normals.
inline RunCost cost_of_grid_surface(const RunSize& size) { return {350 * size.vertices, 190 * size.vertices}; }

/// A mesh with other positions, of which those that reach infinity are left out.
inline RunCost cost_of_moved_mesh(const RunSize& size) { return {0, 48 * size.vertices}; }

/// A mesh that shares its vertices and triangles with the one it is given: they are counted there, but for a little.
inline RunCost cost_of_shared_mesh(const RunSize& size) { return {0, 0, -96 * size.vertices}; }

/// What is told of a mesh to judge whether it can be made, for each of its vertices.
inline constexpr double work_of_solid_facts = 15'000;
inline constexpr double bytes_of_solid_facts = 700;

/// Generators that act together, as a kernel takes them.
inline constexpr double source_bytes = 13 * sizeof(double);

}  // namespace dini

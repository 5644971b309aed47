#pragma once

// What transforms do to each kind of shape. One node, one function per shape type behind it.

#include <cstddef>
#include <vector>

#include "algebra/kernels.h"
#include "algebra/versor.h"
#include "graph/lift.h"

namespace dini {

/// The points of a batch as component arrays of `size` values; spreads a constant over `storage` when needed.
kernels::ConstPoints spread(const Batch<Point>& points, std::size_t size, std::vector<double>& storage);

kernels::ConstNumbers numbers(const Batch<double>& batch);
kernels::Points components(const BatchOut<Point>& out);
kernels::ConstPoints components(const Column<Point>& column, std::size_t begin);
kernels::Points components(Column<Point>& column, std::size_t begin);

/// One versor on a shape. A zero versor is a failure.
std::optional<Failure> apply_to_points(const Versor& versor, const Batch<Point>& shape, const BatchOut<Point>& out);
SharedMesh apply_to_mesh(const Context& context, const Versor& versor, const SharedMesh& mesh);

/// The mesh with new positions: triangles with a corner at infinity or farther than any file can hold are left out with
/// a warning.
std::shared_ptr<Mesh> with_positions(const Context& context, const Mesh& mesh, Column<Point> positions,
                                     Column<Vector> normals);

}  // namespace dini

#pragma once

#include <optional>
#include <string>

#include "geometry/mesh.h"
#include "geometry/welded_mesh.h"

namespace dini {

/// What closes a border.
enum class CapKind { flat, dome };

struct CapOptions {
  CapKind kind = CapKind::flat;
  std::size_t rings = 8;          ///< of triangles on a dome, at least 1
  std::size_t most_vertices = 0;  ///< that all caps together may add
};

struct CappedMesh {
  Mesh mesh;
  std::size_t caps = 0;
  std::optional<std::string> fault;  ///< what makes caps impossible, in words; then the mesh is empty
  bool too_large = false;            ///< the caps would have more vertices than allowed; then the mesh is empty
};

/// A mesh with a cap on every border. A flat cap is a fan about the middle of its border, or cut into ears where the
/// border is not seen whole from there; a border that is not flat gets a cap as flat as it can be. A dome goes on from
/// the surface as it comes: geometry/dome.h. Caps have vertices of their own, at the positions of the border; their
/// normals are the surface's along a dome. With C caps V - E + F becomes C more. A mesh without borders stays as it is.
/// Edges with more than two triangles, or two that run the same way, and borders that meet in one vertex, are faults.
/// Stopped early: an empty mesh.
CappedMesh capped(const Mesh& mesh, const CapOptions& options, const Cancel& cancel);

}  // namespace dini

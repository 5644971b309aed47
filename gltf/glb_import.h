#pragma once

#include "geometry/imported_mesh.h"

namespace dini {

/// Reads the triangles of the default scene of a GLB from anyone: node transforms applied, instances repeated, one mesh
/// in the end. Positions, normals, the first texture coordinates and vertex colors (times the material's base color)
/// are kept; materials otherwise, skins, morph targets and animations are not. Nothing but the file's own binary chunk
/// is ever read: buffers with a URI are refused, data URIs among them. So are Draco and meshopt compression, sparse
/// accessors, and every required extension that is not known here.
ImportResult read_glb_mesh(std::string_view glb, const ImportLimits& limits, const Cancel& cancel = {});

}  // namespace dini

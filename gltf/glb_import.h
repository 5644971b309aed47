#pragma once

#include "geometry/imported_mesh.h"

namespace dini {

/// Reads the triangles of the default scene of a GLB from anyone, as the glTF 2.0 specification says: node transforms
/// applied, instances repeated, skins in the pose that the file's nodes stand in, one mesh in the end. Positions,
/// normals (flat ones where a primitive has none), the first texture coordinates and vertex colors times the material's
/// base color are kept. Plain accessors, sparse ones and those without data (zeros) are read, of every component type.
///
/// Left out with a counted warning: points, lines, textures, animations, cameras, morph targets that have a weight,
/// instances of EXT_mesh_gpu_instancing, hidden nodes, meshes that the scene does not show, and bytes behind the end.
/// Refused, with the accessor, mesh and primitive: values in a buffer with a URI or in a compressed form only (Draco,
/// meshopt), what leads out of the file, and required extensions that are not known. Nothing but the file's own binary
/// chunk is ever read.
ImportResult read_glb_mesh(std::string_view glb, const ImportLimits& limits, const Cancel& cancel = {});

}  // namespace dini

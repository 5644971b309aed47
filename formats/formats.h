#pragma once

#include "geometry/file_format.h"

namespace dini {

// The formats of other programs. All of them are in meters (STL and 3MF in millimeters where the document says a unit)
// with z up, have floats for coordinates, and share one
// primitive for each part; what they cannot hold is told in notes.

/// STL, binary: triangles and nothing else.
FileFormat stl_format();

/// Wavefront OBJ in one file: no materials, colors at the vertices.
FileFormat obj_format();

/// PLY 1.0, binary with the low byte first: all meshes as one, and loose points.
FileFormat ply_format();

/// 3MF: an object for each mesh, with shared vertices, and colors as materials or at the corners of triangles.
FileFormat three_mf_format();

/// SVG: curves seen from above, in millimeters.
FileFormat svg_format();

}  // namespace dini

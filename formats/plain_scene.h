#pragma once

// A scene as formats without compression need it: floats, and only what can be drawn.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/file_format.h"
#include "gltf/lines.h"
#include "gltf/mesh_encoder.h"

namespace dini {

/// A part of a scene. Only one of its three shapes is not empty.
struct PlainPart {
  std::string name;
  std::string material;
  Color color;
  Tile mesh = {};
  FloatRuns curves = {};
  FloatPoints points = {};
};

/// What a format has room for besides triangles.
struct Carried {
  std::string_view format;  ///< as people write it: "STL"
  bool meshes = true;
  bool curves = false;
  bool points = false;
  bool colors = false;
  bool opacity = false;
  bool graph = false;        ///< the document that `about` may have
  bool millimeters = false;  ///< coordinates are millimeters where the document says a unit
};

struct PlainScene {
  std::vector<PlainPart> parts;  ///< those that have something to draw that the format can hold
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  double position_error = 0;    ///< meters, of a point
  bool in_millimeters = false;  ///< else meters
  bool colored = false;         ///< a mesh has another color than meshes have by themselves
  std::vector<FileNote> notes;

  /// The file of these bytes, with the counts and notes of the scene.
  WrittenFile file(std::string bytes) &&;
};

/// Takes a scene apart. Notes tell of parts with nothing to draw, and of what the scene has and the format has not: one
/// for each kind, with the parts by name. Errors: those of `build_tile`, and `nothing-to-export`. Stopped early: an
/// error.
Expected<PlainScene, FileError> plain_scene(const Scene& scene, const FileOptions& options, const Carried& carried,
                                            const Cancel& cancel);

}  // namespace dini

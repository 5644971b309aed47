#pragma once

// What reading a mesh file gives: a mesh or the reason why there is none. The readers (obj_reader.h, ply_reader.h,
// stl_reader.h, and gltf/glb_import.h) take bytes from anyone: they never throw, never allocate by a number that the
// bytes claim before the bytes themselves are there, take memory and time proportional to the bytes and to the limits,
// and look at the cancel flag every some thousand elements.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/cancel.h"
#include "geometry/expected.h"
#include "geometry/mesh.h"

namespace dini {

enum class MeshFormat { obj, ply, stl, glb };

constexpr std::string_view name_of(MeshFormat format) {
  switch (format) {
    case MeshFormat::obj:
      return "obj";
    case MeshFormat::ply:
      return "ply";
    case MeshFormat::stl:
      return "stl";
    case MeshFormat::glb:
      break;
  }
  return "glb";
}

/// A mesh in the file's own axes and units, with unit normals at every vertex. Texture coordinates have their origin at
/// the upper left of the picture, as in glTF; colors are linear. `warnings` tell what the file has and the mesh has
/// not, one sentence with a count for each kind.
struct ImportedMesh {
  Mesh mesh;
  MeshFormat format = MeshFormat::obj;
  std::vector<std::string> warnings = {};
};

/// Of what the triangles of a file are made of in the end; vertices that none uses do not count.
struct ImportLimits {
  std::size_t vertices = 1'000'000;
  std::size_t triangles = 2'000'000;
};

/// Why a file is refused, in one sentence that says where.
struct ImportError {
  enum class Code {
    invalid,    ///< not a file of its format, or with a part that is not supported
    too_large,  ///< well so far, but beyond the limits
    stopped,    ///< not read to its end, because the cancel flag was set
  };

  Code code = Code::invalid;
  std::string detail;
};

using ImportResult = Expected<ImportedMesh, ImportError>;

inline ImportError invalid_file(std::string detail) { return {ImportError::Code::invalid, std::move(detail)}; }

inline ImportError stopped_reading() { return {ImportError::Code::stopped, "the file was not read to its end"}; }

/// "the file has more than 5 vertices".
inline ImportError too_many(std::size_t limit, std::string_view what) {
  return {ImportError::Code::too_large,
          "the file has more than " + std::to_string(limit) + " " + std::string(what) + ", which is the limit"};
}

}  // namespace dini

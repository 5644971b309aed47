#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/cancel.h"
#include "geometry/expected.h"
#include "geometry/json.h"
#include "geometry/scene.h"

namespace dini {

class TopologyCache;  // draco/topology_cache.h

/// How a scene is written. Every format takes from it what it has room for.
struct FileOptions {
  int position_bits = 14;  ///< 8..20 bits over the largest extent, where coordinates are rounded
  int normal_bits = 10;    ///< 6..16 bits per coordinate of a normal
  int uv_bits = 12;        ///< 8..20 bits per texture coordinate over its range
  int speed = 7;           ///< 0 smallest file .. 10 quickest
  bool draco = true;       ///< whether a format that can compresses meshes with Draco
  bool normals = true;
  Json about = nullptr;                 ///< what the file says about itself
  TopologyCache* topologies = nullptr;  ///< what is known of tiles from other files, if anything; no byte depends on it
};

/// Something to say about a file that was written all the same.
struct FileNote {
  std::string code;
  std::string detail;
};

/// How far what vertices carry can be from what was computed; 0 for what a file does not have.
struct AttributeErrors {
  double normal = 0;  ///< radians
  double uv = 0;      ///< of each coordinate, where 1 is the size of a picture
  double color = 0;   ///< of each channel, where 1 is white
};

/// The bytes of a scene in one format, and what is in them.
struct WrittenFile {
  std::string bytes;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  double position_error = 0;  ///< meters: no point in the file is farther from its original
  std::vector<FileNote> notes = {};
  std::optional<AttributeErrors> attribute_errors = {};  ///< where the format knows them
};

/// Why a scene could not be written: `nothing-to-export`, `non-finite`, `limit-exceeded` or `encode-failed`. The first
/// has a detail only where the format is the reason.
struct FileError {
  std::string code;
  std::string detail;
};

/// One way to write a scene. Equal scenes and options give equal bytes. Stopped early, a writer may return anything.
struct FileFormat {
  std::string name;                      ///< what options and requests call it: "glb"
  std::vector<std::string> media_types;  ///< the first is what answers say
  std::string extension;                 ///< with its period: ".glb"
  std::string doc;                       ///< one sentence
  Expected<WrittenFile, FileError> (*write)(const Scene& scene, const FileOptions& options, const Cancel& cancel);
  std::size_t vertex_bytes =
      0;  ///< memory that a vertex of a mesh needs more than in a GLB while it is written, at most
};

/// A format by what it is called, by a media type, or by the end of a file's name (case does not count); null for none.
const FileFormat* format_named(std::span<const FileFormat> formats, std::string_view name);
const FileFormat* format_of_type(std::span<const FileFormat> formats, std::string_view media_type);
const FileFormat* format_of_extension(std::span<const FileFormat> formats, std::string_view extension);

}  // namespace dini

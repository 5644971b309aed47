#include "gltf/encode_cost.h"

#include <algorithm>

namespace dini {

namespace {

// Measured with libdraco 1.5 at 14 bits, with normals and texture coordinates, and rounded up.
constexpr double vertex_work = 1000;       ///< at speeds from 5
constexpr double slow_factor = 3;          ///< below
constexpr double mesh_work = 60'000;       ///< of a mesh, however small
constexpr double point_work = 100;         ///< of a point of a curve, or a loose one
constexpr double tile_bytes = 72;          ///< of a vertex that waits to be compressed
constexpr double compressing_bytes = 240;  ///< of a vertex that is being compressed
constexpr double tile_vertices = 32768;
constexpr double written_bytes = 16;  ///< of a vertex in the file
constexpr double stored_bytes = 40;   ///< the same at speed 10, which hardly compresses
constexpr double plain_work = 60;     ///< of a vertex that is not compressed
constexpr double plain_bytes = 64;    ///< the same in the file: all attributes, and the indices of two triangles
constexpr double part_bytes = 2048;   ///< of what a file says about a mesh or a few curves
constexpr double point_bytes = 3 * sizeof(float);
constexpr double segment_bytes = 2 * 4;  ///< indices of the ends of a segment
constexpr double document_bytes = 64 * 1024;

}  // namespace

EncodeCost encode_cost(const DrawnSizes& sizes, int speed, bool draco) {
  const double factor = speed < 5 ? slow_factor : 1;
  const double points = sizes.curve_points + sizes.curves + sizes.points;
  EncodeCost cost;
  cost.work =
      (draco ? factor * vertex_work : plain_work) * sizes.vertices + mesh_work * sizes.meshes + point_work * points;
  cost.file_bytes = document_bytes + part_bytes * (sizes.meshes + std::min(sizes.curves, 64.0)) +
                    (!draco       ? plain_bytes
                     : speed < 10 ? written_bytes
                                  : stored_bytes) *
                        sizes.vertices +
                    point_bytes * points + segment_bytes * sizes.curve_points;
  // The file exists twice, as its parts and whole; points also as they are before they are written.
  cost.bytes = 2 * cost.file_bytes + (point_bytes + segment_bytes) * points + part_bytes * sizes.meshes +
               tile_bytes * sizes.vertices +
               (draco ? compressing_bytes * std::min(sizes.vertices, most_tiles_at_once * tile_vertices) : 0);
  return cost;
}

}  // namespace dini

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/cancel.h"
#include "geometry/scene.h"
#include "gltf/glb_model.h"
#include "gltf/glb_writer.h"
#include "gltf/mesh_encoder.h"
#include "gltf/tiles.h"

namespace dini {

/// The parts of a scene on their way into a file: first all are prepared together, tile by tile in parallel, then each
/// is written where the caller wants it, in their order. Looks at the flag before every tile and part, and within both
/// but for the compressor.
class SceneEncoding {
 public:
  SceneEncoding(const Scene& scene, const EncodeOptions& options, const Cancel& cancel, const MeshEncoder& encoder)
      : scene_(scene), options_(options), cancel_(cancel), encoder_(encoder) {}

  /// Cuts meshes into tiles, lays the one grid over all of them, and compresses them; or, without Draco, checks them
  /// and rounds them to floats.
  std::optional<EncodeError> prepare();

  /// Adds the primitives of the next part to what the model is at. Errors: `canceled`, `too_large`.
  std::optional<EncodeError> write_next(GlbModel& model);

  /// What was written so far; without the bytes of the file.
  EncodedScene& result() { return result_; }

 private:
  /// One tile on its way through the two parallel passes. Each pass writes only its own tile.
  struct TileJob {
    std::size_t part = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
    Tile tile;
    EncodedTile encoded;
    std::optional<EncodeError> error;
  };

  /// What of a mesh is written: compressed tiles, or the whole as it is.
  void write(const TileJob& job, const Mesh& mesh, bool translucent, GlbModel& model);
  const Mesh& mesh_of(const TileJob& job) const { return *std::get<SharedMesh>(scene_.parts[job.part].shape); }
  std::optional<EncodeError> plan();
  template <class Work>
  std::optional<EncodeError> for_each_job(const Work& work);
  void build(TileJob& job) const;
  void make_grids();
  void encode(TileJob& job) const;
  bool write(const Part& part, const SharedMesh& mesh, GlbModel& model);
  bool write(const Part& part, const std::vector<Polyline>& polylines, GlbModel& model);
  bool write(const Part& part, const CurveSource& curves, GlbModel& model);
  bool write(const Part& part, const SharedColumn<Point>& points, GlbModel& model);
  bool write_runs(const Part& part, const FloatRuns& runs, GlbModel& model);
  void note_plain_errors(const Tile& tile);
  void count_plain_points(std::size_t count, const FloatBox& box);
  std::vector<std::size_t> tile_ends_of(const Mesh& mesh) const;

  const Scene& scene_;
  const EncodeOptions& options_;
  const Cancel& cancel_;
  const MeshEncoder& encoder_;
  std::vector<TileJob> jobs_;
  std::size_t next_job_ = 0;
  std::size_t next_part_ = 0;
  QuantizationGrid position_grid_;
  std::vector<QuantizationGrid> uv_grids_;
  EncodedScene result_;
};

}  // namespace dini

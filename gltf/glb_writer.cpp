#include "gltf/glb_writer.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <tbb/parallel_for.h>
#include <utility>

#include "gltf/draco_encoder.h"
#include "gltf/glb_model.h"
#include "gltf/lines.h"
#include "gltf/tiles.h"

namespace dini {
namespace {

constexpr int uv_bits = 12;
constexpr double rough_uv_error = 1e-3;

// tinygltf counts bytes in int.
constexpr std::size_t largest_binary = std::numeric_limits<int>::max();

// One tile on its way through the two parallel passes. Each pass writes only its own tile.
struct TileJob {
  std::size_t part = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
  Tile tile;
  EncodedTile encoded;
  std::optional<EncodeError> error;
};

class SceneEncoding {
 public:
  SceneEncoding(const Scene& scene, const EncodeOptions& options, const Cancel& cancel, const MeshEncoder& encoder)
      : scene_(scene), options_(options), cancel_(cancel), encoder_(encoder), model_(options.generator) {}

  EncodeResult<EncodedScene> run() {
    if (auto error = plan()) return std::move(*error);
    if (auto error = for_each_job([this](TileJob& job) { build(job); })) return std::move(*error);
    make_grids();
    if (auto error = for_each_job([this](TileJob& job) { encode(job); })) return std::move(*error);
    for (std::size_t part = 0; part < scene_.parts.size(); ++part) {
      if (cancel_.stopped()) return cancelled();
      write_part(part);
      if (model_.binary_size() > largest_binary) {
        return EncodeError{EncodeError::Code::too_large, "The model is larger than 2 GB.", scene_.parts[part].name};
      }
    }
    if (result_.empty_parts.size() == scene_.parts.size()) {
      return EncodeError{EncodeError::Code::empty, "The scene has nothing to draw.", ""};
    }
    result_.glb = model_.write();
    result_.bytes = result_.glb.size();
    if (result_.glb.empty()) {
      return EncodeError{EncodeError::Code::encoder_failed, "The file could not be written.", ""};
    }
    return std::move(result_);
  }

 private:
  static EncodeError cancelled() { return {EncodeError::Code::cancelled, "Encoding was stopped.", ""}; }

  const Mesh& mesh_of(const TileJob& job) const { return *std::get<SharedMesh>(scene_.parts[job.part].shape); }

  std::optional<EncodeError> plan() {
    for (std::size_t part = 0; part < scene_.parts.size(); ++part) {
      const auto* mesh = std::get_if<SharedMesh>(&scene_.parts[part].shape);
      if (mesh == nullptr || *mesh == nullptr) continue;
      if (auto error = check_mesh(**mesh)) {
        error->part = scene_.parts[part].name;
        return error;
      }
      std::size_t begin = 0;
      for (const std::size_t end : plan_tiles(**mesh)) {
        TileJob& job = jobs_.emplace_back();
        job.part = part;
        job.begin = std::exchange(begin, end);
        job.end = end;
      }
    }
    return std::nullopt;
  }

  // Runs `work` on every tile in parallel; the error of the first tile that has one, so errors do not depend on timing.
  template <class Work>
  std::optional<EncodeError> for_each_job(const Work& work) {
    tbb::parallel_for(std::size_t{0}, jobs_.size(), [&](std::size_t i) {
      if (!cancel_.stopped()) work(jobs_[i]);
    });
    if (cancel_.stopped()) return cancelled();
    for (TileJob& job : jobs_) {
      if (!job.error) continue;
      job.error->part = scene_.parts[job.part].name;
      return std::move(job.error);
    }
    return std::nullopt;
  }

  void build(TileJob& job) const {
    auto built = build_tile(mesh_of(job), job.begin, job.end, options_);
    if (auto* error = std::get_if<EncodeError>(&built)) {
      job.error = std::move(*error);
    } else {
      job.tile = std::move(std::get<Tile>(built));
    }
  }

  void make_grids() {
    FloatBox positions;
    std::vector<FloatBox> uvs(scene_.parts.size());
    for (const TileJob& job : jobs_) {
      positions.include(job.tile.position_box);
      uvs[job.part].include(job.tile.uv_box);
    }
    position_grid_ = QuantizationGrid(positions, options_.position_bits);
    for (std::size_t part = 0; part < uvs.size(); ++part) {
      const QuantizationGrid& grid = uv_grids_.emplace_back(uvs[part], uv_bits);
      if (uvs[part].empty() || !(grid.position_error() > rough_uv_error)) continue;
      const auto& [minimum, maximum] = uvs[part];
      result_.rough_uvs.push_back({scene_.parts[part].name, static_cast<double>(std::min(minimum[0], minimum[1])),
                                   static_cast<double>(std::max(maximum[0], maximum[1])), grid.position_error()});
    }
    if (!positions.empty()) result_.position_error = position_grid_.position_error();
  }

  void encode(TileJob& job) const {
    if (job.tile.triangles.empty()) return;
    auto encoded = encoder_.encode(job.tile, {position_grid_, uv_grids_[job.part]}, options_);
    if (auto* error = std::get_if<EncodeError>(&encoded)) {
      job.error = std::move(*error);
      return;
    }
    job.encoded = std::move(std::get<EncodedTile>(encoded));
    Tile boxes;
    boxes.position_box = job.tile.position_box;
    job.tile = std::move(boxes);  // frees the vertices
  }

  void write_part(std::size_t index) {
    const Part& part = scene_.parts[index];
    bool drawn = false;
    if (std::holds_alternative<SharedMesh>(part.shape)) {
      drawn = write_mesh(index);
    } else if (const auto* polylines = std::get_if<std::vector<Polyline>>(&part.shape)) {
      drawn = write_polylines(part, *polylines);
    } else {
      drawn = write_points(part, std::get<Column<Point>>(part.shape));
    }
    if (!drawn) result_.empty_parts.push_back(part.name);
  }

  bool write_mesh(std::size_t index) {
    bool drawn = false;
    for (; next_job_ < jobs_.size() && jobs_[next_job_].part == index; ++next_job_) {
      const TileJob& job = jobs_[next_job_];
      if (job.encoded.bytes.empty()) continue;
      const Mesh& mesh = mesh_of(job);
      if (!drawn) {
        model_.begin_part(scene_.parts[index].name);
        translucent_ = job.encoded.color_id >= 0 && std::any_of(mesh.colors.begin(), mesh.colors.end(),
                                                                [](const auto& color) { return color[3] < 1; });
      }
      drawn = true;
      model_.add_tile(job.encoded, position_grid_.decoded(job.tile.position_box), mesh.color, translucent_);
      result_.vertices += job.encoded.vertices;
      result_.triangles += job.encoded.triangles;
      if (job.encoded.normal_id >= 0) result_.normal_error = octahedral_error(options_.normal_bits);
    }
    return drawn;
  }

  bool write_polylines(const Part& part, const std::vector<Polyline>& polylines) {
    std::vector<FloatPoints> runs;
    for (const Polyline& polyline : polylines) {
      for (FloatPoints& run : drawable_runs(polyline)) runs.push_back(std::move(run));
    }
    if (runs.empty()) return false;
    model_.begin_part(part.name);
    model_.add_runs(runs, part.color);
    for (const FloatPoints& run : runs) count_plain_points(run);
    return true;
  }

  bool write_points(const Part& part, const Column<Point>& points) {
    const FloatPoints drawable = drawable_points(points);
    if (drawable.empty()) return false;
    model_.begin_part(part.name);
    model_.add_points(drawable, part.color);
    count_plain_points(drawable);
    return true;
  }

  // Plain points are rounded to float, nothing else.
  void count_plain_points(const FloatPoints& points) {
    result_.vertices += points.size();
    FloatBox box;
    for (const auto& point : points) box.include(point);
    const double rounding = std::ldexp(static_cast<double>(box.largest()), -24);
    result_.position_error = std::max(result_.position_error, rounding);
  }

  const Scene& scene_;
  const EncodeOptions& options_;
  const Cancel& cancel_;
  const MeshEncoder& encoder_;
  GlbModel model_;
  std::vector<TileJob> jobs_;
  std::size_t next_job_ = 0;
  bool translucent_ = false;
  QuantizationGrid position_grid_;
  std::vector<QuantizationGrid> uv_grids_;
  EncodedScene result_;
};

}  // namespace

EncodeResult<EncodedScene> encode_scene(const Scene& scene, const EncodeOptions& options, const Cancel& cancel) {
  return encode_scene(scene, options, cancel, DracoEncoder());
}

EncodeResult<EncodedScene> encode_scene(const Scene& scene, const EncodeOptions& options, const Cancel& cancel,
                                        const MeshEncoder& encoder) {
  if (auto error = check_options(options)) return std::move(*error);
  try {
    return SceneEncoding(scene, options, cancel, encoder).run();
  } catch (const std::exception& error) {
    return EncodeError{EncodeError::Code::encoder_failed, error.what(), ""};
  }
}

}  // namespace dini

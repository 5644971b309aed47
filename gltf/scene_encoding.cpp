#include "gltf/scene_encoding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <utility>

#include "gltf/encode_cost.h"

namespace dini {
namespace {

constexpr double rough_uv_error = 1.0 / 2000;

// GLB counts bytes in 32 bits, the JSON included, and many readers in an int.
constexpr std::size_t largest_binary = std::numeric_limits<std::int32_t>::max();

}  // namespace

std::optional<EncodeError> SceneEncoding::prepare() {
  if (auto error = plan()) return error;
  if (auto error = for_each_job([this](TileJob& job) { build(job); })) return error;
  if (!options_.draco) return std::nullopt;
  make_grids();
  return for_each_job([this](TileJob& job) { encode(job); });
}

std::optional<EncodeError> SceneEncoding::write_next(GlbModel& model) {
  if (cancel_.stopped()) return canceled();
  const Part& part = scene_.parts[next_part_];
  const bool drawn = std::visit([&](const auto& shape) { return write(part, shape, model); }, part.shape);
  if (cancel_.stopped()) return canceled();
  if (!drawn) result_.empty_parts.push_back(part.name);
  if (model.binary_size() > largest_binary) {
    return EncodeError{EncodeError::Code::too_large, "The model is larger than 2 GB.", part.name};
  }
  ++next_part_;
  return std::nullopt;
}

std::optional<EncodeError> SceneEncoding::plan() {
  for (std::size_t part = 0; part < scene_.parts.size(); ++part) {
    if (cancel_.stopped()) return canceled();
    const auto* mesh = std::get_if<SharedMesh>(&scene_.parts[part].shape);
    if (mesh == nullptr || *mesh == nullptr) continue;
    if (auto error = check_mesh(**mesh)) {
      error->part = scene_.parts[part].name;
      return error;
    }
    std::size_t begin = 0;
    for (const std::size_t end : tile_ends_of(**mesh)) {
      TileJob& job = jobs_.emplace_back();
      job.part = part;
      job.begin = std::exchange(begin, end);
      job.end = end;
    }
  }
  return std::nullopt;
}

// What is not compressed needs no tiles: one primitive for each mesh is what other programs like best.
std::vector<std::size_t> SceneEncoding::tile_ends_of(const Mesh& mesh) const {
  if (options_.draco) return plan_tiles(mesh, tile_sizes(options_));
  return {mesh.triangles.size()};
}

// Runs `work` on every tile in parallel; the error of the first tile that has one, so errors do not depend on timing.
template <class Work>
std::optional<EncodeError> SceneEncoding::for_each_job(const Work& work) {
  tbb::task_arena arena(std::min(tbb::this_task_arena::max_concurrency(), most_tiles_at_once));
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, jobs_.size(), [&](std::size_t i) {
      if (!cancel_.stopped()) work(jobs_[i]);
    });
  });
  if (cancel_.stopped()) return canceled();
  for (TileJob& job : jobs_) {
    if (!job.error) continue;
    job.error->part = scene_.parts[job.part].name;
    return std::move(job.error);
  }
  return std::nullopt;
}

void SceneEncoding::build(TileJob& job) const {
  auto built = build_tile(mesh_of(job), job.begin, job.end, options_, cancel_);
  if (built) {
    job.tile = *std::move(built);
  } else {
    job.error = std::move(built).error();
  }
}

void SceneEncoding::make_grids() {
  FloatBox positions;
  std::vector<FloatBox> uvs(scene_.parts.size());
  for (const TileJob& job : jobs_) {
    positions.include(job.tile.position_box);
    uvs[job.part].include(job.tile.uv_box);
  }
  position_grid_ = QuantizationGrid(positions, options_.position_bits);
  uv_grids_.reserve(uvs.size());
  for (std::size_t part = 0; part < uvs.size(); ++part) {
    const QuantizationGrid& grid = uv_grids_.emplace_back(uvs[part], options_.uv_bits);
    if (uvs[part].empty()) continue;
    result_.attribute_errors.uv = std::max(result_.attribute_errors.uv, grid.position_error());
    if (!(grid.position_error() > rough_uv_error)) continue;
    const auto& [minimum, maximum] = uvs[part];
    result_.rough_uvs.push_back({scene_.parts[part].name, static_cast<double>(std::min(minimum[0], minimum[1])),
                                 static_cast<double>(std::max(maximum[0], maximum[1])), grid.position_error()});
  }
  if (!positions.empty()) result_.position_error = position_grid_.position_error();
}

void SceneEncoding::encode(TileJob& job) const {
  if (job.tile.triangles.empty()) return;
  auto encoded = encoder_.encode(job.tile, {position_grid_, uv_grids_[job.part]}, options_);
  if (!encoded) {
    job.error = std::move(encoded).error();
    return;
  }
  job.encoded = *std::move(encoded);
  Tile boxes;
  boxes.position_box = job.tile.position_box;
  job.tile = std::move(boxes);  // frees the vertices
}

bool SceneEncoding::write(const Part&, const SharedMesh& mesh, GlbModel& model) {
  bool drawn = false, translucent = false;
  for (; next_job_ < jobs_.size() && jobs_[next_job_].part == next_part_; ++next_job_) {
    TileJob& job = jobs_[next_job_];
    if (job.encoded.bytes.empty() && job.tile.triangles.empty()) continue;
    if (!drawn) {
      const bool colored = job.encoded.color_id >= 0 || !job.tile.colors.empty();
      translucent = colored && std::any_of(mesh->colors.begin(), mesh->colors.end(),
                                           [](const auto& color) { return color[3] < 1; });
    }
    drawn = true;
    write(job, *mesh, translucent, model);
    job.encoded.bytes = {};  // they are in the file now
    job.tile = {};
    if (cancel_.stopped()) break;
  }
  return drawn;
}

void SceneEncoding::write(const TileJob& job, const Mesh& mesh, bool translucent, GlbModel& model) {
  const GlbModel::Look look = {mesh.color, mesh.finish, translucent};
  if (!options_.draco) {
    model.add_plain_tile(job.tile, look);
    note_plain_errors(job.tile);
    result_.triangles += job.tile.triangles.size();
    return count_plain_points(job.tile.positions.size(), job.tile.position_box);
  }
  model.add_tile(job.encoded, position_grid_.decoded(job.tile.position_box), look);
  result_.vertices += job.encoded.vertices;
  result_.triangles += job.encoded.triangles;
  AttributeErrors& errors = result_.attribute_errors;
  if (job.encoded.normal_id >= 0) errors.normal = octahedral_error(options_.normal_bits);
  if (job.encoded.color_id >= 0) errors.color = color_error;
}

bool SceneEncoding::write(const Part& part, const std::vector<Polyline>& polylines, GlbModel& model) {
  FloatRuns runs;
  for (const Polyline& polyline : polylines) {
    if (cancel_.stopped()) return false;
    add_drawable_runs(polyline, runs, cancel_);
  }
  return write_runs(part, runs, model);
}

bool SceneEncoding::write(const Part& part, const CurveSource& curves, GlbModel& model) {
  FloatRuns runs;
  for (std::size_t i = 0; i < curves.count; ++i) {
    if (cancel_.stopped()) return false;
    add_drawable_runs(curves.curve(i), runs, cancel_);
  }
  return write_runs(part, runs, model);
}

bool SceneEncoding::write_runs(const Part& part, const FloatRuns& runs, GlbModel& model) {
  if (runs.ends.empty()) return false;
  count_plain_points(runs.points.size(), model.add_runs(runs, part.color, cancel_));
  return true;
}

bool SceneEncoding::write(const Part& part, const SharedColumn<Point>& points, GlbModel& model) {
  const FloatPoints drawable = points == nullptr ? FloatPoints() : drawable_points(*points, cancel_);
  if (drawable.empty()) return false;
  count_plain_points(drawable.size(), model.add_points(drawable, part.color, cancel_));
  return true;
}

// Floats, but for colors.
void SceneEncoding::note_plain_errors(const Tile& tile) {
  AttributeErrors& errors = result_.attribute_errors;
  if (!tile.normals.empty()) errors.normal = 2 * float_rounding;
  if (!tile.uvs.empty()) errors.uv = std::max(errors.uv, float_rounding * static_cast<double>(tile.uv_box.largest()));
  if (!tile.colors.empty()) errors.color = color_error;
}

// Plain points are rounded to float, nothing else.
void SceneEncoding::count_plain_points(std::size_t count, const FloatBox& box) {
  result_.vertices += count;
  const double rounding = std::ldexp(static_cast<double>(box.largest()), -24);
  result_.position_error = std::max(result_.position_error, rounding);
}

}  // namespace dini

#include "geometry/border_strips.h"

#include "geometry/chunks.h"

namespace dini {

namespace {

/// The cosine of the angle from which on a corner of a border shows.
constexpr double even = 0.766;

/// The strips of a wall while their vertices are added to a mesh.
class Strips {
 public:
  Strips(const WallSurface& surface, const std::vector<Vector>& front, const std::vector<Vector>& back, Mesh& mesh,
         const Cancel& cancel)
      : surface_(surface), front_(front), back_(back), mesh_(mesh), vertex_at_(first_vertices(surface.welded, cancel)) {
    const std::size_t vertices = surface.mesh.positions.size(), border = surface.sides.borders.size();
    keeps_corners_ = vertices < few_strip_vertices || 4 * border <= vertices;
  }

  void add_loop(const std::vector<std::uint32_t>& loop) {
    std::vector<Vector> normals;
    for (const std::uint32_t side : loop) normals.push_back(normal_of(side));
    const std::size_t count = loop.size();
    const auto joined = [&](std::size_t i) {  // whether the strip is even where side i begins
      return !keeps_corners_ || dot(normals[(i + count - 1) % count], normals[i]) > even;
    };
    const auto between = [&](std::size_t i) {
      const Vector sum = normalized(normals[(i + count - 1) % count] + normals[i]);
      return sum == Vector{} ? normals[i] : sum;
    };
    const std::uint32_t first = next_;
    std::uint32_t begin = first;
    add_end(start_of(surface_.welded.triangles, loop[0]), joined(0) ? between(0) : normals[0]);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t following = (i + 1) % count;
      std::uint32_t end = next_;
      if (following == 0 && joined(0)) {
        end = first;
      } else {
        add_end(end_of(surface_.welded.triangles, loop[i]), joined(following) ? between(following) : normals[i]);
      }
      mesh_.triangles.push_back({end, begin, begin + 1});
      mesh_.triangles.push_back({end, begin + 1, end + 1});
      if (following == 0) break;
      begin = end;
      if (joined(following)) continue;
      begin = next_;
      add_end(start_of(surface_.welded.triangles, loop[following]), normals[following]);
    }
  }

  void write(const Cancel& cancel) {
    Column<Point> positions(next_);
    Column<Vector> normals(next_);
    const std::size_t before = mesh_.positions.size();
    for_chunks(cancel, before, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        positions.set(i, mesh_.positions[i]);
        normals.set(i, mesh_.normals[i]);
      }
    });
    for (std::size_t i = before; i < next_; ++i) {
      positions.set(i, to_point(added_positions_[i - before]));
      normals.set(i, added_normals_[i - before]);
    }
    mesh_.positions = std::move(positions);
    mesh_.normals = std::move(normals);
    mesh_.tile_ends.push_back(mesh_.triangles.size());
  }

 private:
  /// Outward across the border, of length 1.
  Vector normal_of(std::uint32_t side) const {
    const std::uint32_t p = start_of(surface_.welded.triangles, side), q = end_of(surface_.welded.triangles, side);
    const Vector along = (front_[p] - front_[q]) + (back_[p] - back_[q]);
    const Vector across = (back_[p] - front_[p]) + (back_[q] - front_[q]);
    const Vector normal = normalized(cross(normalized(along), normalized(across)));
    return normal == Vector{} ? Vector{0, 0, 1} : normal;
  }

  /// A vertex in front and one behind.
  void add_end(std::uint32_t vertex, const Vector& normal) {
    for (const std::vector<Vector>* sheet : {&front_, &back_}) {
      added_positions_.push_back((*sheet)[vertex]);
      added_normals_.push_back(normal);
      if (!mesh_.uvs.empty()) mesh_.uvs.push_back(surface_.mesh.uvs[vertex_at_[vertex]]);
      if (!mesh_.colors.empty()) mesh_.colors.push_back(surface_.mesh.colors[vertex_at_[vertex]]);
      ++next_;
    }
  }

  const WallSurface& surface_;
  const std::vector<Vector>&front_, &back_;
  Mesh& mesh_;
  std::vector<std::size_t> vertex_at_;  ///< of the surface, by distinct position
  bool keeps_corners_ = true;
  std::vector<Vector> added_positions_, added_normals_;
  std::uint32_t next_ = static_cast<std::uint32_t>(mesh_.positions.size());
};

}  // namespace

void add_border_strips(const WallSurface& surface, const std::vector<Vector>& front, const std::vector<Vector>& back,
                       Mesh& sheets, const Cancel& cancel) {
  if (surface.borders.loops.empty()) return;
  Strips strips(surface, front, back, sheets, cancel);
  for (const std::vector<std::uint32_t>& loop : surface.borders.loops) {
    if (cancel.stopped()) return;
    strips.add_loop(loop);
  }
  strips.write(cancel);
}

}  // namespace dini

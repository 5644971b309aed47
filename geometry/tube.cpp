#include "geometry/tube.h"

#include <algorithm>

#include "geometry/angle.h"
#include "geometry/chunks.h"
#include "geometry/clip.h"
#include "geometry/frames.h"
#include "geometry/tiles.h"

namespace dini {

namespace {

/// Writes the tubes of pieces one after another into one mesh that has room for all of them.
class TubeWriter {
 public:
  TubeWriter(const TubeOptions& options, std::size_t sides, std::size_t vertices, const Cancel& cancel)
      : radius_(options.radius),
        sides_(sides),
        capped_(options.capped),
        cancel_(cancel),
        positions_(vertices),
        normals_(vertices),
        uvs_(vertices) {
    triangles_.reserve(2 * vertices);
    for (std::size_t side = 0; side < sides; ++side) {
      around_.push_back(sine_cosine(static_cast<double>(side) / static_cast<double>(sides)));
    }
  }

  static std::size_t vertices_of(const CurvePiece& piece, std::size_t sides, bool capped) {
    return piece.points.size() * sides + (piece.closed || !capped ? 0 : 2 * (sides + 1));
  }

  void add(const CurvePiece& piece) {
    double total = 0;
    const std::vector<Frame> frames = frames_along(piece, total, cancel_);
    if (cancel_.stopped()) return;
    const std::size_t stations = frames.size(), base = next_vertex_;
    const std::size_t at_once = std::max<std::size_t>(1, usual_chunk / sides_);
    for_chunks(cancel_, stations, at_once, [&](std::size_t begin, std::size_t end) {
      for (std::size_t station = begin; station < end; ++station) {
        const Frame& frame = frames[station];
        for (std::size_t side = 0; side < sides_; ++side) {
          const Vector normal = direction(frame, side);
          set_vertex(base + station * sides_ + side, frame.position + radius_ * normal, normal, frame.along / total,
                     coordinate(side));
        }
      }
    });
    next_vertex_ += stations * sides_;
    const bool capped = capped_ && !piece.closed;
    const std::size_t steps = piece.closed ? stations : stations - 1;
    for_each_tile(steps, sides_,
                  [&](std::size_t row_begin, std::size_t row_end, std::size_t side_begin, std::size_t side_end) {
                    if (capped && row_begin == 0 && side_begin == 0) add_cap(frames.front(), 0);
                    add_quads({row_begin, row_end, side_begin, side_end}, base, stations);
                    if (capped && row_end == steps && side_end == sides_) add_cap(frames.back(), 1);
                    tile_ends_.push_back(triangles_.size());
                    return !cancel_.stopped();
                  });
  }

  Mesh take() {
    Mesh mesh;
    mesh.positions = std::move(positions_);
    mesh.normals = std::move(normals_);
    mesh.uvs = std::move(uvs_);
    mesh.triangles = std::move(triangles_);
    mesh.tile_ends = std::move(tile_ends_);
    return mesh;
  }

 private:
  Vector direction(const Frame& frame, std::size_t side) const {
    return normalized(around_[side].cosine * frame.across + around_[side].sine * cross(frame.tangent, frame.across));
  }

  double coordinate(std::size_t side) const { return static_cast<double>(side) / static_cast<double>(sides_); }

  /// A flat fan at the start (u = 0) or the end (u = 1) of a piece.
  void add_cap(const Frame& frame, double u) {
    const Vector normal = u == 0 ? -frame.tangent : frame.tangent;
    const std::size_t center = next_vertex_;
    next_vertex_ += sides_ + 1;
    set_vertex(center, frame.position, normal, u, 0.5);
    for (std::size_t side = 0; side < sides_; ++side) {
      set_vertex(center + 1 + side, frame.position + radius_ * direction(frame, side), normal, u, coordinate(side));
    }
    for (std::size_t side = 0; side < sides_; ++side) {
      const std::size_t a = center + 1 + side;
      const std::size_t b = center + 1 + (side + 1) % sides_;
      triangles_.push_back(triangle(center, u == 0 ? b : a, u == 0 ? a : b));
    }
  }

  struct Quads {
    std::size_t row_begin, row_end, side_begin, side_end;
  };

  void add_quads(const Quads& quads, std::size_t base, std::size_t stations) {
    const std::size_t first = triangles_.size(), across = quads.side_end - quads.side_begin;
    triangles_.resize(first + 2 * across * (quads.row_end - quads.row_begin));
    std::array<std::uint32_t, 3>* out = triangles_.data() + first;
    for (std::size_t row = quads.row_begin; row < quads.row_end; ++row) {
      const std::size_t here = base + row * sides_;
      const std::size_t there = base + (row + 1) % stations * sides_;
      for (std::size_t side = quads.side_begin; side < quads.side_end; ++side) {
        const std::size_t next = side + 1 < sides_ ? side + 1 : 0;
        *out++ = triangle(here + side, here + next, there + next);
        *out++ = triangle(here + side, there + next, there + side);
      }
    }
  }

  void set_vertex(std::size_t index, const Vector& position, const Vector& normal, double u, double v) {
    positions_.set(index, to_point(position));
    normals_.set(index, normal);
    uvs_[index] = {u, v};
  }

  static std::array<std::uint32_t, 3> triangle(std::size_t a, std::size_t b, std::size_t c) {
    return {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)};
  }

  double radius_;
  std::size_t sides_;
  bool capped_;
  const Cancel& cancel_;
  std::vector<SineCosine> around_;
  std::size_t next_vertex_ = 0;
  Column<Point> positions_;
  Column<Vector> normals_;
  NumberList<std::array<double, 2>> uvs_;
  NumberList<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::size_t> tile_ends_;
};

}  // namespace

Mesh tube(const Polyline& curve, const TubeOptions& options, const Cancel& cancel) {
  if (!(options.radius > 0 && options.radius <= largest_clip_radius)) return {};
  const std::size_t sides = std::max<std::size_t>(options.sides, 3);
  const std::vector<CurvePiece> pieces = curve_pieces(curve, options.clip_radius, cancel);
  std::size_t vertices = 0;
  for (const CurvePiece& piece : pieces) vertices += TubeWriter::vertices_of(piece, sides, options.capped);
  TubeWriter writer(options, sides, vertices, cancel);
  for (const CurvePiece& piece : pieces) {
    writer.add(piece);
    if (cancel.stopped()) return {};
  }
  return writer.take();
}

}  // namespace dini
